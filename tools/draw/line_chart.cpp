#include "tools/draw/line_chart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "tools/draw/axes.h"
#include "tools/draw/colours.h"
#include "tools/draw/legend.h"

namespace lasius::tool {
namespace {

constexpr const char* kIteration = "iteration";  // a whole number

/// All values, or with `lengths` what matters: up to the highest that a curve has after its first
/// tenth. Whether the axis is logarithmic is decided here.
Range shown(const LineChart& chart, bool& logarithmic) {
  Range range;
  for (const Level& level : chart.levels) range.add(level.value);
  for (const Curve& curve : chart.curves) {
    const auto settled = chart.lengths && !curve.dots ? curve.y.size() / 10 : 0;
    for (std::size_t i = settled; i < curve.y.size(); ++i) range.add(curve.y[i]);
    for (std::size_t i = settled; i < curve.low.size(); ++i) range.add(curve.low[i]);
  }
  if (range.empty()) return {0, 1};
  logarithmic = chart.logarithmic && range.low > 0 && range.high > 3 * range.low;
  if (logarithmic) return {range.low / 1.1, range.high * 1.1};
  const double room = 0.06 * std::max({range.high - range.low, 0.016, 0.02 * range.high});
  return {chart.lengths ? std::max(0.0, range.low - room) : range.low - room, range.high + room};
}

Range span_of_x(const LineChart& chart) {
  Range range;
  range.add(0);
  for (const Curve& curve : chart.curves)
    for (const double x : curve.x) range.add(x);
  return range.low < range.high ? range : Range{0, 1};
}

/// What lies between two stairs.
void draw_band(Canvas& canvas, const Axes& axes, const Curve& curve) {
  std::vector<Point> rim;
  const auto add = [&](std::size_t i, const std::vector<double>& side, double x) {
    const double y = std::isfinite(side[i]) ? side[i] : 2 * axes.y.high;
    rim.push_back(axes.at(x, std::clamp(y, axes.y.low, axes.y.high)));
  };
  const auto until = [&](std::size_t i) { return curve.x[std::min(i + 1, curve.x.size() - 1)]; };
  for (std::size_t i = 0; i < curve.high.size(); ++i) {
    add(i, curve.high, curve.x[i]);
    add(i, curve.high, until(i));
  }
  for (std::size_t i = curve.low.size(); i-- > 0;) {
    add(i, curve.low, until(i));
    add(i, curve.low, curve.x[i]);
  }
  if (!rim.empty()) canvas.area(rim, curve.colour, 0.12, false);
}

void draw_curve(Canvas& canvas, const Axes& axes, const Curve& curve) {
  if (!curve.dots)
    return draw_curve(canvas, axes, curve.x, curve.y, curve.stairs, curve.colour, curve.width);
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    if (!axes.shows(curve.y[i])) continue;
    const Point p = axes.at(curve.x[i], curve.y[i]);
    canvas.fill({p.x - 1.5, p.y - 1.5, 3, 3}, curve.colour);
  }
}

std::vector<Key> keys_of(const LineChart& chart) {
  std::vector<Key> keys;
  for (const Curve& curve : chart.curves)
    keys.push_back(line_key(curve.label, curve.colour, curve.dots ? 4 : 2.5));
  for (const auto& level : chart.levels)
    if (!level.label.empty()) keys.push_back(dashed_key(level.label, level.colour));
  return keys;
}

}  // namespace

Colour palette(std::size_t index) {
  static constexpr Colour kColours[] = {{0.84, 0.37, 0.0},  {0.0, 0.45, 0.7}, {0.0, 0.62, 0.45},
                                        {0.8, 0.47, 0.65},  {0.9, 0.62, 0.0}, {0.34, 0.71, 0.91},
                                        {0.35, 0.35, 0.35}, {0.55, 0.3, 0.1}};
  return kColours[index % std::size(kColours)];
}

void draw(Canvas& canvas, const Box& box, const LineChart& chart) {
  constexpr double kTitle = 32, kBelow = kAxisBottom + 10;
  const double top = box.y + (chart.title.empty() ? 8 : kTitle);
  const double width = box.width - kAxisLeft - 10;
  const auto keys = keys_of(chart);
  Canvas measure;
  const double bottom = box.y + box.height - draw_legend(measure, {}, width, keys) - kBelow;
  Axes axes{.box = {box.x + kAxisLeft, top, width, std::max(20.0, bottom - top)},
            .x = span_of_x(chart),
            .y = {},
            .whole_x = chart.x_label == kIteration};
  axes.y = shown(chart, axes.logarithmic);
  canvas.text({box.x + box.width / 2, box.y + 18}, chart.title, 17, Align::centre, kInk, true);
  draw_axes(canvas, axes, chart.x_label, chart.y_label + (axes.logarithmic ? " (log)" : ""), true);
  for (const Curve& curve : chart.curves) draw_band(canvas, axes, curve);
  for (const Level& level : chart.levels)
    if (axes.shows(level.value))
      canvas.dashed(axes.at(axes.x.low, level.value), axes.at(axes.x.high, level.value),
                    level.colour, 1.5);
  for (auto curve = chart.curves.rbegin(); curve != chart.curves.rend(); ++curve)
    draw_curve(canvas, axes, *curve);
  draw_legend(canvas, {axes.box.x, bottom + kBelow}, width, keys);
}

void draw_convergence(Canvas& canvas, const Box& box, const Convergence& convergence) {
  // Of the best path so far, then of the tours.
  static constexpr Colour kColours[] = {
      {0.8, 0.15, 0.15}, {0.25, 0.45, 0.7}, {0.0, 0.62, 0.45}, {0.8, 0.47, 0.65}, {0.55, 0.3, 0.1}};
  std::vector<Level> of_best = convergence.levels, of_tours = convergence.levels;
  constexpr double kRounding = 1e-9;  // of a level that is the best path's
  Range best;
  for (const double value : convergence.best.values) best.add(convergence.scale * value);
  if (!best.empty())
    std::erase_if(of_best,
                  [&](const Level& level) { return level.value > (1 + kRounding) * best.high; });
  for (Level& level : of_tours)
    if (std::ranges::count(of_best, level.label, &Level::label) > 0) level.label.clear();
  const auto chart_of = [&](std::span<const Convergence::Series> all, std::size_t colour) {
    const bool is_best = colour == 0;
    LineChart chart{.title = "",
                    .x_label = kIteration,
                    .y_label = "length, " + convergence.unit,
                    .levels = is_best ? of_best : of_tours,
                    .lengths = false,
                    .logarithmic = true};
    for (const auto& [label, values] : all) {
      Curve curve{.label = label,
                  .colour = kColours[colour++],
                  .stairs = false,
                  .width = is_best ? 2.5 : 1.5};
      for (const double value : values) {
        curve.x.push_back(static_cast<double>(curve.x.size() + 1));
        curve.y.push_back(convergence.scale * value);
      }
      if (!values.empty()) chart.curves.push_back(std::move(curve));
    }
    return chart;
  };
  const bool beside = box.width > 2 * box.height;
  Box part{box.x, box.y, beside ? std::floor(box.width / 2) : box.width,
           beside ? box.height : std::floor(box.height / 2)};
  draw(canvas, part, chart_of({&convergence.best, 1}, 0));
  (beside ? part.x : part.y) += beside ? part.width : part.height;
  draw(canvas, part, chart_of(convergence.tours, 1));
}

}  // namespace lasius::tool
