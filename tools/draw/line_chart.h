// Curves over a common axis, with a legend.
#pragma once

#include <string>
#include <vector>

#include "tools/draw/canvas.h"

namespace lasius::tool {

struct Curve {
  std::string label;
  Colour colour;
  std::vector<double> x = {};
  std::vector<double> y = {};    ///< NaN or infinite where there is none
  std::vector<double> low = {};  ///< of a band around it; empty: none
  std::vector<double> high = {};
  bool dots = false;    ///< points that are not joined
  bool stairs = true;   ///< a value holds until the next; else joined by lines
  double width = 2.25;  ///< pixels
};

/// A dashed line.
struct Level {
  std::string label;  ///< empty: the legend does not name it
  double value;
  Colour colour{0.15, 0.17, 0.2};
};

struct LineChart {
  std::string title, x_label, y_label;  ///< an empty title takes no room
  std::vector<Curve> curves = {};
  std::vector<Level> levels = {};
  bool lengths = true;       ///< values are 0 or more, and far larger ones at first may be left out
  bool logarithmic = false;  ///< y, where some values are many times others
};

/// Draws over the whole box: title, axes, curves, and the legend below. With `lengths` the vertical
/// axis leaves out what lies far above the last values of the curves.
void draw(Canvas& canvas, const Box& box, const LineChart& chart);

/// The colour of curve or path number `index`, told apart by people who see colours differently
/// (Okabe and Ito 2008).
Colour palette(std::size_t index);

/// How a search converged, in two charts above or beside each other: the best so far, and an
/// iteration's tours, each with the dashed levels, but that of the best without those above all of
/// it, as the optimum of walks is where paths are smoothed.
struct Convergence {
  struct Series {
    std::string label;
    const std::vector<double>& values;  ///< by iteration; NaN where there is none
  };
  Series best;
  std::vector<Series> tours;  ///< four at most; one without values is left out
  std::vector<Level> levels = {};
  std::string unit = "cells";
  double scale = 1;  ///< of all values: units by what they are given in
};
void draw_convergence(Canvas& canvas, const Box& box, const Convergence& convergence);

}  // namespace lasius::tool
