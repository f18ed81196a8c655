// Whether points and discs keep from what is blocked along a path, by distances of their own.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "lasius/grid/grid.h"
#include "lasius/path/path.h"

namespace lasius::tool {

/// Where a path first breaks a rule.
struct PathFault {
  double along = 0;            ///< cells of the path before it
  Point at{};                  ///< there
  std::optional<Cell> cell{};  ///< that is met
  std::string why;             ///< as in "enters the blocked cell (3, 4)"
};

/// Of a point: by the rule of the plane. `squeezes`: it may pass between diagonal blocks.
std::optional<PathFault> point_fault(const Grid& grid, std::span<const Point> path, bool squeezes);

/// Of a disc along lines and arcs: it keeps `radius` from blocked squares and from the outside, to
/// 1e-9 cells.
std::optional<PathFault> disc_fault(const Grid& grid, double radius, const lasius::Curve& curve);

/// Lines between points.
lasius::Curve lines_between(std::span<const Point> path);
/// Of lines and arcs.
double length_of(const lasius::Curve& curve);

}  // namespace lasius::tool
