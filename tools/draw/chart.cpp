#include "tools/draw/chart.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "tools/draw/colours.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr Colour kBest{0.8, 0.15, 0.15};
constexpr Colour kMean{0.25, 0.45, 0.7};
constexpr Colour kOptimum{0.35, 0.35, 0.35};
constexpr double kLabel = 14;

/// Values on a logarithmic axis: lengths of early tours are many times the best.
class Axis {
 public:
  Axis(double low, double high, double from, double to, bool logarithmic)
      : low_(low), high_(high), from_(from), to_(to), logarithmic_(logarithmic) {}
  double at(double value) const {
    const double share = logarithmic_ ? std::log(value / low_) / std::log(high_ / low_)
                                      : (value - low_) / (high_ - low_);
    return from_ + share * (to_ - from_);
  }

 private:
  double low_, high_, from_, to_;
  bool logarithmic_;
};

/// 1, 2, 5 times powers of ten within [low, high].
std::vector<double> log_ticks(double low, double high) {
  std::vector<double> marks;
  const int last = static_cast<int>(std::floor(std::log10(high)));
  for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= last; ++decade)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double mark = factor * std::pow(10, decade);
      if (mark >= low && mark <= high) marks.push_back(mark);
    }
  return marks;
}

void draw_curve(Canvas& canvas, const Axis& x, const Axis& y, const std::vector<double>& values,
                Colour colour, double width) {
  std::vector<Point> points;
  for (std::size_t i = 0; i <= values.size(); ++i) {
    if (i < values.size() && std::isfinite(values[i])) {
      points.push_back({x.at(static_cast<double>(i) + 1), y.at(values[i])});
      continue;
    }
    canvas.polyline(points, colour, width);
    points.clear();
  }
}

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

void draw_lengths(Canvas& canvas, const Plot& plot, const Range& range, const Axis& y,
                  bool logarithmic) {
  const int wanted = std::max(2, static_cast<int>(plot.box.height / 45));
  const auto marks =
      logarithmic ? log_ticks(range.low, range.high) : ticks(range.low, range.high, wanted);
  const double step = logarithmic || marks.size() < 2 ? 1 : marks[1] - marks[0];
  for (const double mark : marks) {
    const double at = y.at(mark), left = plot.box.x;
    canvas.line({left, at}, {left + plot.box.width, at}, kGrid, 1);
    canvas.text({left - 8, at + 5}, tick_label(mark, step), kLabel, Align::right, kInk);
  }
}

void draw_iterations(Canvas& canvas, const Plot& plot, const Axis& x, double last) {
  const double bottom = plot.box.y + plot.box.height;
  for (const double mark : ticks(1, last, static_cast<int>(plot.box.width / 90))) {
    if (mark < 1 || mark != std::floor(mark)) continue;
    canvas.line({x.at(mark), bottom}, {x.at(mark), bottom - 5}, kInk, 1);
    if (plot.labelled)
      canvas.text({x.at(mark), bottom + 20}, tick_label(mark, 1), kLabel, Align::centre, kInk);
  }
  if (plot.labelled)
    canvas.text({plot.box.x + plot.box.width / 2, bottom + 42}, "iteration", kLabel + 1,
                Align::centre, kInk);
}

void draw_plot(Canvas& canvas, const Plot& plot) {
  Range range;
  for (const double value : plot.values) range.add(value);
  if (plot.optimum) range.add(*plot.optimum);
  const bool none = range.empty();
  if (none) range.add(1);
  const bool logarithmic = range.low > 0 && range.high > 3 * range.low;
  range = padded(range, logarithmic);
  const Box& box = plot.box;
  const double last = std::max(2.0, static_cast<double>(plot.values.size()));
  const Axis x(1, last, box.x, box.x + box.width, false);
  const Axis y(range.low, range.high, box.y + box.height, box.y, logarithmic);

  if (none)
    canvas.text({box.x + box.width / 2, box.y + box.height / 2}, "no ant has arrived", kLabel,
                Align::centre, kInk);
  else
    draw_lengths(canvas, plot, range, y, logarithmic);
  draw_iterations(canvas, plot, x, last);
  std::string name = plot.name + (logarithmic ? ", logarithmic" : "");
  if (plot.optimum) {
    canvas.dashed({box.x, y.at(*plot.optimum)}, {box.x + box.width, y.at(*plot.optimum)}, kOptimum,
                  1.5);
    name += "; dashed: " + plot.optimum_name;
  }
  draw_curve(canvas, x, y, plot.values, plot.colour, plot.width);
  canvas.frame(box, kInk, 1);
  const double width = canvas.text_width(name, kLabel + 1);
  canvas.text({box.x + box.width - 10, box.y + 20}, name, kLabel + 1, Align::right, kInk);
  canvas.line({box.x + box.width - width - 44, box.y + 15},
              {box.x + box.width - width - 18, box.y + 15}, plot.colour, plot.width);
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

std::string tick_label(double value, double step) {
  return study::fixed(value, step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

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
  canvas.text({box.x + 16, box.y + 2 + (upper + kBetween + height - upper) / 2},
              "length in " + data.unit, kLabel + 1, Align::centre, kInk, false, true);
}

}  // namespace lasius::tool
