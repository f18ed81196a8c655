// Why a path is none, by means that share nothing with the library.
#pragma once

#include <cmath>
#include <span>
#include <string>

#include "tests/oracle/plane_rule.h"

namespace lasius::rule {

/// Whether two lengths are the same, but for rounding.
inline bool same_length(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * (1 + std::abs(a));
}

/// Why a path is none from start to goal of that length; empty where it is one.
inline std::string path_fault(const Grid& grid, std::span<const Point> path, Point start,
                              Point goal, double length) {
  if (path.empty() || path.front() != start || path.back() != goal)
    return "a path that does not join start and goal";
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  if (!same_length(sum, length))
    return "length " + std::to_string(length) + " of a path of " + std::to_string(sum);
  return Checker(grid).obeys(path) ? "" : "a path through what is blocked";
}

}  // namespace lasius::rule
