// Convergence by iteration, as a chart with axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/draw/axes.h"

namespace lasius::tool {

struct Convergence {
  std::vector<double> best;  ///< by iteration; NaN where there is none
  std::vector<double> mean;
  std::optional<double> optimum;
  std::string unit = "cells";
  std::string optimum_name = "optimum";
};

void draw_convergence(Canvas& canvas, const Box& box, const Convergence& data);

}  // namespace lasius::tool
