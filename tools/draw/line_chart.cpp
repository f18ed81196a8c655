#include "tools/draw/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/draw/axes.h"
#include "tools/draw/colours.h"

namespace lasius::study {
namespace {

using tool::Align;
using tool::Axes;
using tool::Box;
using tool::Canvas;
using tool::Colour;
using tool::draw_curve;
using tool::kInk;
using tool::kLabelSize;
using tool::Range;

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

void draw_curve(Canvas& canvas, const Axes& axes, const Curve& curve) {
  if (curve.dots) {
    for (std::size_t i = 0; i < curve.y.size(); ++i) {
      if (!axes.shows(curve.y[i])) continue;
      const Point p = axes.at(curve.x[i], curve.y[i]);
      canvas.fill({p.x - 1.5, p.y - 1.5, 3, 3}, curve.colour);
    }
    return;
  }
  const Colour pale = tool::blend(curve.colour, {1, 1, 1}, 0.55);
  draw_curve(canvas, axes, curve.x, curve.low, true, pale, 1);
  draw_curve(canvas, axes, curve.x, curve.high, true, pale, 1);
  draw_curve(canvas, axes, curve.x, curve.y, true, curve.colour, 2.25);
}

/// The text, or as much of it as there is room for.
std::string fitted(Canvas& canvas, const std::string& text, double width) {
  if (canvas.text_width(text, kLabelSize) <= width) return text;
  std::size_t kept = text.size();
  const auto within = [&] { return (text[kept] & 0xc0) == 0x80; };  // a character of UTF-8
  while (kept > 0 &&
         (within() || canvas.text_width(text.substr(0, kept) + "...", kLabelSize) > width))
    --kept;
  return text.substr(0, kept) + "...";
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
    canvas.text({at.x + 34, at.y + 5}, fitted(canvas, curve.label, box.width / kLegendColumns - 42),
                kLabelSize, Align::left, kInk);
  }
  if (chart.level) {
    const Point at = place(i);
    canvas.dashed(at, {at.x + 26, at.y}, kInk, 1.5);
    canvas.text({at.x + 34, at.y + 5}, chart.level_label, kLabelSize, Align::left, kInk);
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
  const Axes axes{{box.x + kLeft, box.y + kTop, box.width - kLeft - 10,
                   box.height - kTop - kBelowAxis - legend},
                  span_of_x(chart),
                  lengths_shown(chart)};
  const Box& inner = axes.box;
  canvas.text({box.x + box.width / 2, box.y + 22}, chart.title, 17, Align::centre, kInk, true);
  draw_rows(canvas, axes, static_cast<int>(inner.height / 50));
  draw_columns(canvas, axes, static_cast<int>(inner.width / 100), chart.x_label, false);
  draw_side_label(canvas, inner, kLeft - 18, chart.y_label);
  if (chart.level)
    canvas.dashed(axes.at(axes.x.low, *chart.level), axes.at(axes.x.high, *chart.level), kInk, 1.5);
  for (auto curve = chart.curves.rbegin(); curve != chart.curves.rend(); ++curve)
    draw_curve(canvas, axes, *curve);
  canvas.frame(inner, kInk, 1);
  draw_legend(canvas, {inner.x, inner.y + inner.height + kBelowAxis, inner.width, legend}, chart);
}

Canvas chart_page(const std::vector<LineChart>& charts, int width, int height) {
  constexpr int kMargin = 20;
  const int count = static_cast<int>(charts.size());
  Canvas canvas(count * (width + kMargin) + kMargin, height + 2 * kMargin);
  Box box{kMargin, kMargin, 1.0 * width, 1.0 * height};
  for (const LineChart& chart : charts) {
    draw(canvas, box, chart);
    box.x += width + kMargin;
  }
  return canvas;
}

}  // namespace lasius::study
