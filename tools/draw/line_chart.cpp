#include "tools/draw/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/draw/chart.h"
#include "tools/draw/colours.h"

namespace lasius::study {
namespace {

using tool::Align;
using tool::Box;
using tool::Canvas;
using tool::Colour;
using tool::kGrid;
using tool::kInk;
using tool::Range;
using tool::tick_label;

constexpr double kText = 14;
constexpr double kLeft = 84, kTop = 40, kBelowAxis = 54, kLegendLine = 22;
constexpr int kLegendColumns = 2;

/// From what matters: the lowest value up to the highest that a curve has after its first tenth.
Range lengths_shown(const LineChart& chart) {
  Range range;
  if (chart.level) range.add(*chart.level);
  for (const Curve& curve : chart.curves) {
    if (curve.y.empty()) continue;
    const auto settled = curve.dots ? 0 : curve.y.size() / 10;
    for (std::size_t i = settled; i < curve.y.size(); ++i) range.add(curve.y[i]);
    for (std::size_t i = settled; i < curve.low.size(); ++i) range.add(curve.low[i]);
  }
  if (!chart.lengths) {
    for (const Curve& curve : chart.curves)
      for (const double y : curve.y) range.add(y);
    const double room = std::max(0.06 * (range.high - range.low), 1e-3);
    return {range.low - room, range.high + room};
  }
  if (range.empty()) range = {0, 1};
  const double spread = std::max(range.high - range.low, 0.01 * std::max(1.0, range.high));
  return {std::max(0.0, range.low - 0.06 * spread), range.high + 0.1 * spread};
}

Range span_of_x(const LineChart& chart) {
  Range range;
  range.add(0);
  for (const Curve& curve : chart.curves)
    for (const double x : curve.x) range.add(x);
  return range.low < range.high ? range : Range{0, 1};
}

/// From values to the page, cut at the top edge.
struct Frame {
  Box box;
  Range x, y;
  Point at(double px, double py) const {
    return {box.x + (px - x.low) / (x.high - x.low) * box.width,
            box.y + box.height - (py - y.low) / (y.high - y.low) * box.height};
  }
};

void draw_axes(Canvas& canvas, const Frame& frame, const LineChart& chart) {
  const Box& box = frame.box;
  const auto rows = tool::ticks(frame.y.low, frame.y.high, static_cast<int>(box.height / 50));
  for (const double mark : rows) {
    const double y = frame.at(0, mark).y;
    canvas.line({box.x, y}, {box.x + box.width, y}, kGrid, 1);
    const double step = rows.size() > 1 ? rows[1] - rows[0] : 1;
    canvas.text({box.x - 8, y + 5}, tick_label(mark, step), kText, Align::right, kInk);
  }
  const auto columns = tool::ticks(frame.x.low, frame.x.high, static_cast<int>(box.width / 100));
  const double bottom = box.y + box.height;
  for (const double mark : columns) {
    const double x = frame.at(mark, 0).x;
    canvas.line({x, bottom}, {x, bottom - 5}, kInk, 1);
    const double step = columns.size() > 1 ? columns[1] - columns[0] : 1;
    canvas.text({x, bottom + 20}, tick_label(mark, step), kText, Align::centre, kInk);
  }
  canvas.text({box.x + box.width / 2, bottom + 42}, chart.x_label, kText, Align::centre, kInk);
  canvas.text({box.x - kLeft + 18, box.y + box.height / 2}, chart.y_label, kText, Align::centre,
              kInk, false, true);
}

/// The stretches of a curve that lie inside the frame, as stairs: a value holds until the next.
void draw_stretches(Canvas& canvas, const Frame& frame, const std::vector<double>& x,
                    const std::vector<double>& y, Colour colour, double width) {
  std::vector<Point> points;
  for (std::size_t i = 0; i <= y.size(); ++i) {
    if (i < y.size() && y[i] >= frame.y.low && y[i] <= frame.y.high) {
      const Point next = frame.at(x[i], y[i]);
      if (!points.empty()) points.push_back({next.x, points.back().y});
      points.push_back(next);
      continue;
    }
    canvas.polyline(points, colour, width);
    points.clear();
  }
}

void draw_curve(Canvas& canvas, const Frame& frame, const Curve& curve) {
  if (curve.dots) {
    for (std::size_t i = 0; i < curve.y.size(); ++i) {
      if (!(curve.y[i] >= frame.y.low && curve.y[i] <= frame.y.high)) continue;
      const Point p = frame.at(curve.x[i], curve.y[i]);
      canvas.fill({p.x - 1.5, p.y - 1.5, 3, 3}, curve.colour);
    }
    return;
  }
  const Colour pale = tool::blend(curve.colour, {1, 1, 1}, 0.55);
  draw_stretches(canvas, frame, curve.x, curve.low, pale, 1);
  draw_stretches(canvas, frame, curve.x, curve.high, pale, 1);
  draw_stretches(canvas, frame, curve.x, curve.y, curve.colour, 2.25);
}

void draw_legend(Canvas& canvas, const Box& box, const LineChart& chart) {
  const auto place = [&](std::size_t i) {
    return Point{box.x + static_cast<double>(i % kLegendColumns) * box.width / kLegendColumns,
                 box.y + static_cast<double>(i / kLegendColumns) * kLegendLine + 10};
  };
  std::size_t i = 0;
  for (const Curve& curve : chart.curves) {
    const Point at = place(i++);
    canvas.line(at, {at.x + 26, at.y}, curve.colour, curve.dots ? 4 : 2.5);
    canvas.text({at.x + 34, at.y + 5}, curve.label, kText, Align::left, kInk);
  }
  if (chart.level) {
    const Point at = place(i);
    canvas.dashed(at, {at.x + 26, at.y}, kInk, 1.5);
    canvas.text({at.x + 34, at.y + 5}, chart.level_label, kText, Align::left, kInk);
  }
}

}  // namespace

Colour palette(std::size_t index) {
  static constexpr std::array<Colour, 8> kColours{{{0.84, 0.37, 0.0},
                                                   {0.0, 0.45, 0.7},
                                                   {0.0, 0.62, 0.45},
                                                   {0.8, 0.47, 0.65},
                                                   {0.9, 0.62, 0.0},
                                                   {0.34, 0.71, 0.91},
                                                   {0.35, 0.35, 0.35},
                                                   {0.55, 0.3, 0.1}}};
  return kColours[index % kColours.size()];
}

void draw(Canvas& canvas, const Box& box, const LineChart& chart) {
  const std::size_t entries = chart.curves.size() + (chart.level ? 1 : 0);
  const double legend =
      static_cast<double>((entries + kLegendColumns - 1) / kLegendColumns) * kLegendLine;
  const Frame frame{{box.x + kLeft, box.y + kTop, box.width - kLeft - 10,
                     box.height - kTop - kBelowAxis - legend},
                    span_of_x(chart),
                    lengths_shown(chart)};
  canvas.text({box.x + box.width / 2, box.y + 22}, chart.title, 17, Align::centre, kInk, true);
  draw_axes(canvas, frame, chart);
  if (chart.level)
    canvas.dashed(frame.at(frame.x.low, *chart.level), frame.at(frame.x.high, *chart.level), kInk,
                  1.5);
  for (auto curve = chart.curves.rbegin(); curve != chart.curves.rend(); ++curve)
    draw_curve(canvas, frame, *curve);
  canvas.frame(frame.box, kInk, 1);
  draw_legend(canvas,
              {frame.box.x, frame.box.y + frame.box.height + kBelowAxis, frame.box.width, legend},
              chart);
}

}  // namespace lasius::study
