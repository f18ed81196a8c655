#include "tools/draw/chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/draw/colours.h"

namespace lasius::tool {
namespace {

constexpr Colour kBest{0.8, 0.15, 0.15};
constexpr Colour kMean{0.25, 0.45, 0.7};
constexpr Colour kOptimum{0.35, 0.35, 0.35};

/// One curve over the iterations, with its own axis of lengths.
struct Plot {
  Box box;  ///< of the axes, without their labels
  const std::vector<double>& values;
  std::string name;
  Colour colour;
  double width;
  std::optional<double> optimum;
  std::string optimum_name;
  bool labelled;  ///< says what the iterations are
};

/// Room around the curve, more above it: for its name.
Range padded(const Range& range, bool logarithmic) {
  if (logarithmic) return {range.low / 1.1, range.high * std::pow(range.high / range.low, 0.3)};
  const double spread = std::max(range.high - range.low, 0.01 * std::max(1.0, range.high));
  return {std::max(0.0, range.low - 0.1 * spread), range.high + 0.35 * spread};
}

void draw_plot(Canvas& canvas, const Plot& plot) {
  Range range;
  for (const double value : plot.values) range.add(value);
  if (plot.optimum) range.add(*plot.optimum);
  const bool none = range.empty();
  if (none) range.add(1);
  const bool logarithmic = range.low > 0 && range.high > 3 * range.low;
  const Box& box = plot.box;
  const auto count = static_cast<double>(plot.values.size());
  const Axes axes{box, count > 1 ? Range{1, count} : Range{0.5, 1.5}, padded(range, logarithmic),
                  logarithmic};
  if (none)
    canvas.text({box.x + box.width / 2, box.y + box.height / 2}, "no ant has arrived", kLabelSize,
                Align::centre, kInk);
  else
    draw_rows(canvas, axes, std::max(2, static_cast<int>(box.height / 45)));
  draw_columns(canvas, axes, static_cast<int>(box.width / 90), plot.labelled ? "iteration" : "",
               true);
  std::string name = plot.name + (logarithmic ? ", logarithmic" : "");
  if (plot.optimum) {
    canvas.dashed(axes.at(axes.x.low, *plot.optimum), axes.at(axes.x.high, *plot.optimum), kOptimum,
                  1.5);
    name += "; dashed: " + plot.optimum_name;
  }
  std::vector<double> iterations(plot.values.size());
  std::iota(iterations.begin(), iterations.end(), 1.0);
  draw_curve(canvas, axes, iterations, plot.values, false, plot.colour, plot.width);
  if (count == 1 && !none) canvas.disc(axes.at(1, plot.values[0]), 4, plot.colour);
  canvas.frame(box, kInk, 1);
  const double width = canvas.text_width(name, kLabelSize + 1);
  canvas.text({box.x + box.width - 10, box.y + 20}, name, kLabelSize + 1, Align::right, kInk);
  canvas.line({box.x + box.width - width - 44, box.y + 15},
              {box.x + box.width - width - 18, box.y + 15}, plot.colour, plot.width);
}

}  // namespace

void draw_convergence(Canvas& canvas, const Box& box, const Convergence& data) {
  constexpr double kLeft = 84, kBottom = 50, kBetween = 14;
  const double width = box.width - kLeft - 4, height = box.height - kBottom - kBetween - 4;
  const double upper = std::floor(0.58 * height);
  draw_plot(canvas, {{box.x + kLeft, box.y + 2, width, upper},
                     data.best,
                     "best so far",
                     kBest,
                     2.5,
                     data.optimum,
                     data.optimum_name,
                     false});
  draw_plot(canvas, {{box.x + kLeft, box.y + 2 + upper + kBetween, width, height - upper},
                     data.mean,
                     "mean tour of the ants",
                     kMean,
                     1.75,
                     {},
                     {},
                     true});
  draw_side_label(canvas, {box.x + kLeft, box.y + 2, width, kBetween + height}, kLeft - 16,
                  "length in " + data.unit);
}

}  // namespace lasius::tool
