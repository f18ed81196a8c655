// Shortest walks by the moves of ants, after Bellman and Ford: a yardstick that is slow and simple.
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"

namespace lasius::oracle {

struct Step {
  int dx, dy;
};

inline std::vector<Step> steps_of(Neighbours neighbours) {
  const bool square = neighbours >= Neighbours::twenty_four;
  std::vector<Step> steps;
  for (int dy = -3; dy <= 3; ++dy) {
    for (int dx = -3; dx <= 3; ++dx) {
      const int reach = std::max(std::abs(dx), std::abs(dy));
      const bool knight = std::abs(dx * dy) == 2;
      const bool straight = dx == 0 || dy == 0 || std::abs(dx) == std::abs(dy);
      if (neighbours == Neighbours::four
              ? std::abs(dx) + std::abs(dy) == 1
              : reach == 1 || (square && reach == 2) ||
                    (neighbours == Neighbours::sixteen && straight && reach == 2) ||
                    (neighbours == Neighbours::sixteen_knight && knight) ||
                    (neighbours == Neighbours::thirty_two && straight && reach == 3)) {
        steps.push_back({dx, dy});
      }
    }
  }
  return steps;
}

// Cell by cell along straight and diagonal moves; a knight's move needs sight.
inline bool passes(const Grid& grid, Cell at, Step step, Corners corners) {
  const int reach = std::gcd(step.dx, step.dy);
  const int dx = step.dx / reach, dy = step.dy / reach;
  if (dx * dx + dy * dy > 2) {
    return rule::segment_obeys(
        grid, {2 * at.x + 1, 2 * at.y + 1, 2 * (at.x + step.dx) + 1, 2 * (at.y + step.dy) + 1});
  }
  for (int i = 0; i < reach; ++i) {
    const Cell from = at;
    at = {at.x + dx, at.y + dy};
    if (grid.blocked(at)) return false;
    if (dx != 0 && dy != 0 && !passes_corner(grid, corners, from, at)) return false;
  }
  return true;
}

inline double move_length(Cell, Step step) {
  return std::sqrt(step.dx * step.dx + step.dy * step.dy);
}

/// Lengths of the shortest walks from one cell to every other, row by row; infinite where there is
/// none. Every move is relaxed until nothing changes. `cost(from, step)`: of a move, infinite where
/// it is not to be made.
template <class CostOf = decltype(&move_length)>
std::vector<double> relaxed_walks(const Grid& grid, Cell start, Neighbours neighbours,
                                  Corners corners, const CostOf& cost = move_length) {
  const auto steps = steps_of(neighbours);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> best(static_cast<std::size_t>(grid.width()) * grid.height(), kFar);
  const auto at = [&](Cell c) -> double& {
    return best[static_cast<std::size_t>(c.y) * grid.width() + c.x];
  };
  at(start) = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Cell c : cells_of(grid)) {
      if (at(c) == kFar) continue;
      for (const Step step : steps) {
        if (!passes(grid, c, step, corners)) continue;
        const double through = at(c) + cost(c, step);
        double& known = at({c.x + step.dx, c.y + step.dy});
        if (through >= known - 1e-12) continue;
        known = through;
        changed = true;
      }
    }
  }
  return best;
}

}  // namespace lasius::oracle
