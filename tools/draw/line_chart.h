// Curves over a common axis, with a legend.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/draw/canvas.h"

namespace lasius::study {

struct Curve {
  std::string label;
  tool::Colour colour;
  std::vector<double> x = {};
  std::vector<double> y = {};    ///< NaN or infinite where there is none
  std::vector<double> low = {};  ///< of a band around it; empty: none
  std::vector<double> high = {};
  bool dots = false;  ///< points that are not joined
};

struct LineChart {
  std::string title, x_label, y_label;
  std::vector<Curve> curves = {};
  std::optional<double> level = {};  ///< a dashed line
  std::string level_label = {};
  bool lengths = true;  ///< values are 0 or more, and far larger ones at first may be left out
};

/// Draws over the whole box: title, axes, curves, and the legend below. The vertical axis leaves
/// out what lies far above the last values of the curves.
void draw(tool::Canvas& canvas, const tool::Box& box, const LineChart& chart);

/// A page of charts side by side, each of this size.
tool::Canvas chart_page(const std::vector<LineChart>& charts, int width, int height);

/// The colour of curve or path number `index`, told apart by people who see colours differently
/// (Okabe and Ito 2008).
tool::Colour palette(std::size_t index);

}  // namespace lasius::study
