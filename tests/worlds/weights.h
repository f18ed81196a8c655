// Small random maps with weights, for tests of costs.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "lasius/cost/field.h"
#include "lasius/grid/grid.h"
#include "lasius/plan/planner.h"
#include "tests/worlds/grids.h"

namespace lasius {

struct WeightedWorld {
  Grid grid;
  CostField costs;
  Cell start, goal;
};

/// Start and goal joined and apart.
inline WeightedWorld random_weights(std::mt19937& random, int least_side, int most_side) {
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  for (;;) {
    const int width = least_side + below(most_side - least_side + 1);
    const int height = least_side + below(most_side - least_side + 1);
    Grid grid = random_grid(width, height, 10 + below(31), random);
    std::vector<double> weights(static_cast<std::size_t>(width) * height);
    const int kind = below(3);
    for (double& w : weights)
      w = kind == 0 ? 1 + below(3) : kind == 1 ? 0.2 + 0.01 * below(900) : 1;
    if (kind == 2) weights[below(width * height)] = 50;
    const Cell start{below(width), below(height)}, goal{below(width), below(height)};
    if (grid.blocked(start) || grid.blocked(goal) || start == goal) continue;
    if (!Planner(Grid(grid)).connected(start, goal)) continue;
    return {grid, CostField(width, height, weights), start, goal};
  }
}

}  // namespace lasius
