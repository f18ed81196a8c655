// What a planner on a bitmap answers.
#pragma once

#include <optional>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/path/path.h"
#include "lasius/plan/search_result.h"

namespace lasius {

/// Another way than the shortest one.
struct Alternative {
  std::vector<Point> path;  ///< from where the shortest one begins to where it ends
  double length = 0;        ///< in cells
  friend bool operator==(const Alternative&, const Alternative&) = default;
};

/// One answer; lengths in cells.
struct Result : SearchResult {
  /// From start to goal, cells' centres or the points asked for; one point where they are the same,
  /// none without a path. Of walks over cells that begin or end at points, what ants, observers and
  /// the other curves are about is the walk between centres of cells there; `path`, `length` and
  /// `curves.best` are with the ends.
  /// Of a disc's curve a polyline that keeps the radius as well and is at most a thousandth longer.
  std::vector<Point> path;
  /// Of `exact` for a disc: the path itself, whose length `length` is; else empty.
  Curve curve;
  /// Of a disc that stands nearer than its radius to what is blocked: the nearest place from which
  /// the goal can be reached, of those that a straight leg leads to which is nowhere nearer than
  /// the start. `exact` takes a point that just keeps the radius, the others a cell's centre. Path,
  /// curve and their lengths begin with the leg; the rest is the plan from here, which is all that
  /// a target gap, ants' tours and observers are about. Nothing is certified of the whole.
  std::optional<Point> way_out;
  /// With a goal tolerance: the cell where the path ends, or is to end. There its last vertex is
  /// the centre, or for a disc, by `exact`, the point nearest to the goal.
  std::optional<Cell> goal_reached;
  std::optional<Cell> nearest_free;  ///< to a start or goal that is blocked or outside
  /// The same among the cells that are joined to the other end, where that is free; with a goal
  /// tolerance also of a goal in another region.
  std::optional<Cell> nearest_reachable;
  /// With Request::via: which of them, from 0, is blocked, outside, or cannot be reached from the
  /// point before it. Of a whole path `curves.best` begins with the last leg, NaN in iterations
  /// before; all other curves are of the legs, one after another.
  std::optional<int> bad_via;
  /// Rules of the caller's own took part, see OwnRules: parameters and seed alone do not give this
  /// answer again.
  bool own_rules = false;
  /// With Request::alternatives: other ways, beside a path that is proven shortest, in the order of
  /// their lengths; fewer where there are no more. Each is taut, hence the shortest of all that
  /// pass obstacles on the same sides, goes over some corner by the shortest ways to it and from
  /// it, and does not cross itself. It is at most 1.3 times as long as `path`; at most 70% of it is
  /// nearer to `path` and the alternatives before than a hundredth of the length of `path` (at
  /// least one cell), and around that corner a quarter of that length is itself a shortest path.
  /// Those that a prepared map has may differ where ways are of one length. If a stop condition
  /// ends the search for them, the status tells, and they are those that were found.
  std::vector<Alternative> alternatives;
};

}  // namespace lasius
