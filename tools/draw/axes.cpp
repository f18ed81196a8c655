#include "tools/draw/axes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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
  return study::fixed(value, step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
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
  const double decade = std::pow(10, std::floor(std::log10(raw)));
  const double factor = raw / decade;
  const double step = decade * (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10);
  std::vector<double> marks;
  const auto first = static_cast<std::int64_t>(std::ceil(low / step - 1e-9));
  const auto last = static_cast<std::int64_t>(std::floor(high / step + 1e-9));
  for (auto i = first; i <= last; ++i) marks.push_back(static_cast<double>(i) * step);
  return marks;
}

Point Axes::at(double px, double py) const {
  const double rise = logarithmic ? std::log(py / y.low) / std::log(y.high / y.low)
                                  : (py - y.low) / (y.high - y.low);
  return {box.x + (px - x.low) / (x.high - x.low) * box.width,
          box.y + box.height - rise * box.height};
}

void draw_rows(Canvas& canvas, const Axes& axes, int count) {
  const auto marks = axes.logarithmic ? log_ticks(axes.y) : ticks(axes.y.low, axes.y.high, count);
  const double left = axes.box.x;
  for (const double mark : marks) {
    const double y = axes.at(axes.x.low, mark).y;
    canvas.line({left, y}, {left + axes.box.width, y}, kGrid, 1);
    const double step = axes.logarithmic ? mark : step_of(marks);
    canvas.text({left - 8, y + 5}, tick_label(mark, step), kLabelSize, Align::right, kInk);
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

void draw_side_label(Canvas& canvas, const Box& box, double left, const std::string& label) {
  canvas.text({box.x - left, box.y + box.height / 2}, label, kLabelSize + 1, Align::centre, kInk,
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
    canvas.polyline(points, colour, width);
    points.clear();
  }
}

}  // namespace lasius::tool
