// Paths between centres of cells that are to begin and end at other points.
#pragma once

#include <span>
#include <vector>

#include "core/disc/disc_space.h"
#include "core/smooth/taut_string.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"

namespace lasius {

/// Puts a point before and one behind a path, each of which sees the path's own end, and polishes
/// what comes of it as Polish says: taut is the shortest path of the class; straight and local
/// leave out vertices next to the ends, as far as an end sees; none leaves the path's ends in.
class PathEnds {
 public:
  /// `disc`: whose paths, null for a point's on `grid`. All but the ends must outlive it.
  PathEnds(const Grid& grid, const disc::DiscSpace* disc, const Params& params, Point from,
           Point to) noexcept
      : grid_(grid), disc_(disc), params_(params), from_(from), to_(to) {}

  /// The path with its new ends. Vertices of `path` are multiples of 1/2 unless it is a disc's; it
  /// has at least one.
  std::vector<Point> join(std::span<const Point> path, const StopCondition& stop);

 private:
  bool sees(Point a, Point b) const noexcept;

  const Grid& grid_;
  const disc::DiscSpace* disc_;
  const Params& params_;
  Point from_, to_;
  TautString taut_;
};

}  // namespace lasius
