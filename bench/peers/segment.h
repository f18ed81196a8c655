// Whether a segment between any two points is free: for planners that bend anywhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/peers/runs.h"
#include "lasius/grid/grid.h"

namespace lasius::peers {

/// True when no cell that the closed segment touches is blocked. A segment on a grid line touches
/// the cells to its right and below only.
inline bool segment_clear(const Grid& grid, Point a, Point b) noexcept {
  if (a.y > b.y) std::swap(a, b);
  const auto column = [](double x) { return static_cast<int>(std::floor(x)); };
  const int first_row = column(a.y), last_row = column(b.y);
  const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
  double enter = a.x;
  for (int y = first_row; y <= last_row; ++y) {
    const double leave = y == last_row ? b.x : a.x + slope * (y + 1 - a.y);
    const int lo = column(std::min(enter, leave)), hi = column(std::max(enter, leave));
    if (y < 0 || y >= grid.height() || lo < 0 || hi >= grid.width()) return false;
    if (!run_free(grid.row(y), lo, hi)) return false;
    enter = leave;
  }
  return true;
}

}  // namespace lasius::peers
