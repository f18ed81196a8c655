#include "tools/draw/axes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tools/console/values.h"
#include "tools/draw/colours.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

/// 1, 2, 5 times powers of ten within a range.
std::vector<double> log_ticks(const Range& range) {
  std::vector<double> marks;
  const int last = static_cast<int>(std::floor(std::log10(range.high)));
  for (int decade = static_cast<int>(std::floor(std::log10(range.low))); decade <= last; ++decade)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double mark = factor * std::pow(10, decade);
      if (mark >= range.low && mark <= range.high) marks.push_back(mark);
    }
  return marks;
}

/// A mark's number with the decimals that marks `step` apart need.
std::string tick_label(double value, double step) {
  if (std::abs(value) >= 1e9) return short_number(value);
  return fixed(value, step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

double step_of(const std::vector<double>& marks) {
  return marks.size() > 1 ? marks[1] - marks[0] : 1;
}

}  // namespace

void Range::add(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

std::vector<double> ticks(double low, double high, int count) {
  const double raw = (high - low) / std::max(count, 1);
  // Too far from 0 to tell steps apart, or nothing to divide.
  if (!(raw > 0) || !(std::max(std::abs(low), std::abs(high)) < 1e15 * raw)) return {};
  const double decade = std::pow(10, std::floor(std::log10(raw)));
  const double factor = raw / decade;
  const double step = decade * (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10);
  std::vector<double> marks;
  const auto first = static_cast<std::int64_t>(std::ceil(low / step - 1e-9));
  const auto last = static_cast<std::int64_t>(std::floor(high / step + 1e-9));
  for (auto i = first; i <= last; ++i) marks.push_back(static_cast<double>(i) * step);
  return marks;
}

std::vector<double> axis_marks(const Range& range, bool logarithmic, int count) {
  if (!(range.low < range.high)) return {range.low};
  // Within less than a factor of 5 there may be no round logarithmic mark but one.
  return logarithmic && range.high > 5 * range.low ? log_ticks(range)
                                                   : ticks(range.low, range.high, count);
}

std::string short_number(double value) {
  return printed("%.4g", std::abs(value) < 1e-300 ? 0.0 : value);
}

double share_of(const Range& range, bool logarithmic, double value) {
  return logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                     : (value - range.low) / (range.high - range.low);
}

Point Axes::at(double px, double py) const {
  return {box.x + share_of(x, false, px) * box.width,
          box.y + box.height - share_of(y, logarithmic, py) * box.height};
}

std::vector<Point> Axes::at(std::span<const Point> points) const {
  std::vector<Point> page;
  for (const Point p : points) page.push_back(at(p.x, p.y));
  return page;
}

void draw_axes(Canvas& canvas, const Axes& axes, const std::string& across, const std::string& up,
               bool grid) {
  constexpr double kTick = 4, kRoom = kAxisLeft - 30, kNameSize = 13;
  const Box& box = axes.box;
  const double bottom = box.y + box.height, right = box.x + box.width;
  const Range x{std::min(axes.x.low, axes.x.high), std::max(axes.x.low, axes.x.high)};
  const Range y{std::min(axes.y.low, axes.y.high), std::max(axes.y.low, axes.y.high)};
  const auto count = [](const Range& range, bool whole, double pixels, double apart, int least) {
    const int most = std::max(least, static_cast<int>(pixels / apart));
    return whole && range.high - range.low < most ? static_cast<int>(range.high - range.low) : most;
  };
  const auto columns = axis_marks(x, false, count(x, axes.whole_x, box.width, 75, 1));
  const auto rows =
      axis_marks(y, axes.logarithmic, count(y, axes.whole_y, box.height, 45, grid ? 3 : 1));
  double free = 0;  // to the right of the last mark's text
  for (const double mark : columns) {
    const double at = axes.at(mark, axes.y.low).x;
    if (grid) canvas.line({at, box.y}, {at, bottom}, kGrid, 1);
    canvas.line({at, bottom}, {at, bottom + kTick}, kInk, 1);
    const std::string text = tick_label(mark, step_of(columns));
    const double half = canvas.text_width(text, kMarkSize) / 2;
    if (at - half < free) continue;
    canvas.text({at, bottom + 17}, text, kMarkSize, Align::centre, kInk);
    free = at + half + 5;
  }
  const bool decades = axes.logarithmic && y.high > 5 * y.low;
  double last = -1e9;
  for (const double mark : rows) {
    const double at = axes.at(axes.x.low, mark).y;
    if (grid) canvas.line({box.x, at}, {right, at}, kGrid, 1);
    canvas.line({box.x - kTick, at}, {box.x, at}, kInk, 1);
    if (std::abs(at - last) < kMarkSize) continue;
    last = at;
    const std::string text = tick_label(mark, decades ? mark : step_of(rows));
    const double size = std::min(kMarkSize, kMarkSize * kRoom / canvas.text_width(text, kMarkSize));
    canvas.text({box.x - 7, at + 4}, text, size, Align::right, kInk);
  }
  canvas.frame(box, kInk, 1);
  canvas.text({box.x + box.width / 2, bottom + 34}, across, kNameSize, Align::centre, kInk);
  const double name = std::min(
      kNameSize, kNameSize * std::max(box.height, 60.0) / canvas.text_width(up, kNameSize));
  canvas.text({box.x - kAxisLeft + 11, box.y + box.height / 2}, up, name, Align::centre, kInk,
              false, true);
}

void draw_curve(Canvas& canvas, const Axes& axes, const std::vector<double>& x,
                const std::vector<double>& y, bool stairs, Colour colour, double width) {
  std::vector<Point> points;
  for (std::size_t i = 0; i <= y.size(); ++i) {
    if (i < y.size() && axes.shows(y[i])) {
      const Point next = axes.at(x[i], y[i]);
      if (stairs && !points.empty()) points.push_back({next.x, points.back().y});
      points.push_back(next);
      continue;
    }
    if (points.size() == 1)
      canvas.disc(points[0], 4, colour);  // between gaps
    else
      canvas.polyline(points, colour, width);
    points.clear();
  }
}

}  // namespace lasius::tool
