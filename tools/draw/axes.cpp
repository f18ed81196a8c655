#include "tools/draw/axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

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
  return study::fixed(value, step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

double step_of(const std::vector<double>& marks) {
  return marks.size() > 1 ? marks[1] - marks[0] : 1;
}

/// The same whichever way the range runs.
Range rising(const Range& range) {
  return {std::min(range.low, range.high), std::max(range.low, range.high)};
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
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", std::abs(value) < 1e-300 ? 0.0 : value);
  return text.data();
}

Point Axes::at(double px, double py) const {
  const double rise = logarithmic ? std::log(py / y.low) / std::log(y.high / y.low)
                                  : (py - y.low) / (y.high - y.low);
  return {box.x + (px - x.low) / (x.high - x.low) * box.width,
          box.y + box.height - rise * box.height};
}

void draw_rows(Canvas& canvas, const Axes& axes, int count) {
  const auto marks = axis_marks(axes.y, axes.logarithmic, count);
  const double left = axes.box.x;
  for (const double mark : marks) {
    const double y = axes.at(axes.x.low, mark).y;
    canvas.line({left, y}, {left + axes.box.width, y}, kGrid, 1);
    const bool decades = axes.logarithmic && axes.y.high > 5 * axes.y.low;
    canvas.text({left - 8, y + 5}, tick_label(mark, decades ? mark : step_of(marks)), kLabelSize,
                Align::right, kInk);
  }
}

void draw_columns(Canvas& canvas, const Axes& axes, int count, const std::string& label,
                  bool whole) {
  const auto marks = ticks(axes.x.low, axes.x.high, count);
  const double step = whole ? 1 : step_of(marks);
  const double bottom = axes.box.y + axes.box.height;
  for (const double mark : marks) {
    if (whole && mark != std::floor(mark)) continue;
    const double x = axes.at(mark, axes.y.low).x;
    canvas.line({x, bottom}, {x, bottom - 5}, kInk, 1);
    if (!label.empty())
      canvas.text({x, bottom + 20}, tick_label(mark, step), kLabelSize, Align::centre, kInk);
  }
  canvas.text({axes.box.x + axes.box.width / 2, bottom + 42}, label, kLabelSize + 1, Align::centre,
              kInk);
}

void draw_plane_axes(Canvas& canvas, const Axes& axes, const std::string& across,
                     const std::string& up, bool whole) {
  constexpr double kSize = 12, kTick = 4, kRoom = kPlaneLeft - 24;
  const Box& box = axes.box;
  const double bottom = box.y + box.height;
  const auto marks = [&](const Range& range, double pixels, double apart) {
    const double most = whole ? std::min(pixels / apart, range.high - range.low) : pixels / apart;
    return ticks(range.low, range.high, std::max(1, static_cast<int>(most)));
  };
  const auto columns = marks(rising(axes.x), box.width, 70);
  double free = 0;  // to the right of the last mark's text
  for (const double mark : columns) {
    const double x = axes.at(mark, axes.y.low).x;
    const std::string text = tick_label(mark, step_of(columns));
    const double half = canvas.text_width(text, kSize) / 2;
    canvas.line({x, bottom}, {x, bottom + kTick}, kInk, 1);
    if (x - half < free) continue;
    canvas.text({x, bottom + 17}, text, kSize, Align::centre, kInk);
    free = x + half + 5;
  }
  const auto rows = marks(rising(axes.y), box.height, 45);
  double last = -1e9;
  for (const double mark : rows) {
    const double y = axes.at(axes.x.low, mark).y;
    const std::string text = tick_label(mark, step_of(rows));
    canvas.line({box.x - kTick, y}, {box.x, y}, kInk, 1);
    if (std::abs(y - last) < kSize) continue;
    last = y;
    const double size = std::min(kSize, kSize * kRoom / canvas.text_width(text, kSize));
    canvas.text({box.x - 7, y + 4}, text, size, Align::right, kInk);
  }
  canvas.frame(box, kInk, 1);
  canvas.text({box.x + box.width / 2, bottom + 33}, across, kSize, Align::centre, kInk);
  canvas.text({box.x - kPlaneLeft + 12, box.y + box.height / 2}, up, kSize, Align::centre, kInk,
              false, true);
}

void draw_side_label(Canvas& canvas, const Box& box, double left, const std::string& label) {
  const double size = std::min(
      kLabelSize + 1, (kLabelSize + 1) * box.height / canvas.text_width(label, kLabelSize + 1));
  canvas.text({box.x - left, box.y + box.height / 2}, label, size, Align::centre, kInk, false,
              true);
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
