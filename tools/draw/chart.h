// Convergence by iteration, as a chart with axes.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tools/draw/canvas.h"

namespace lasius::tool {

struct Convergence {
  std::vector<double> best;  ///< by iteration; NaN where there is none
  std::vector<double> mean;
  std::optional<double> optimum;
  std::string unit = "cells";
  std::string optimum_name = "optimum";
};

/// What an axis shows.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  /// Takes in a value where it is finite.
  void add(double value);
  bool empty() const { return !(low <= high); }
};

/// Round numbers that cover [low, high] in about `count` steps, low < high.
std::vector<double> ticks(double low, double high, int count);

/// A mark's number with the decimals that marks `step` apart need.
std::string tick_label(double value, double step);

void draw_convergence(Canvas& canvas, const Box& box, const Convergence& data);

}  // namespace lasius::tool
