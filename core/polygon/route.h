// Line sequences: Dijkstra's through midpoints, and the best crossing points of one sequence.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/poller.h"
#include "core/polygon/regions.h"
#include "lasius/polygon/plan.h"

namespace lasius::polygon {

/// A start or goal: the point as it was given, on the grid, and the regions that hold it.
struct Place {
  Point given;
  LatticePoint at;
  std::vector<int> regions;
};

/// One line that a route crosses. Crossing points are a + h (b - a), h in [0, 1].
struct Gate {
  int link = 0;
  Point a, b;
  LatticePoint left, right;  ///< ends as seen on the way to the goal
  bool a_is_left = false;

  Point at(double h) const noexcept { return {a.x + h * (b.x - a.x), a.y + h * (b.y - a.y)}; }
};

/// Start, goal and the lines crossed on the way.
struct Route {
  Place start, goal;
  std::vector<Gate> gates;
};

/// Shows `visit` the `count` shortest ways through midpoints of lines, or as many as there are, the
/// shortest first: Dijkstra's, then Yen's way of asking for the next (1971). Ties to fewer lines,
/// then to lower numbers. Ends where `visit` says false or, after the first, the poller says stop.
void midpoint_routes(const Regions& regions, const Place& start, const Place& goal, int count,
                     Poller& poller, const std::function<bool(const Route&)>& visit);

/// The path through given points of the gates.
Crossing cross_at(const Route& route, std::vector<double> values);

/// Shortest path over `values` evenly spaced points of each gate, by dynamic programming; nothing
/// where it was stopped.
std::optional<Crossing> discrete_optimum(const Route& route, int values, Poller& poller);

/// Shortest path over any points of the gates: the funnel (Lee & Preparata 1984), sides decided
/// without rounding.
Crossing sequence_optimum(const Route& route, const FreeSpace& space);

}  // namespace lasius::polygon
