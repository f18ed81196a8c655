// Worlds in which tours are planned, whatever they are made of.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// What a tour has to know of a world: which stops are joined, and the legs between them. Asked
/// from several threads at once.
class LASIUS_EXPORT TourWorld {
 public:
  virtual ~TourWorld() = default;
  /// Whether a point is within the world's bounds, blocked or not.
  virtual bool inside(Point p) const = 0;
  /// To each point the regions that it is of, numbered from 0: points are joined where they have a
  /// region in common. None of a point that is outside or blocked.
  virtual std::vector<std::vector<int>> regions(std::span<const Point> points) const = 0;
  /// The lengths of legs between all of some points that are joined, row by row, the same both
  /// ways, off by at most 1e-9 of each. Nothing if stopped.
  virtual std::optional<std::vector<double>> distances(std::span<const Point> points, int threads,
                                                       const StopCondition& stop) const = 0;
  /// The leg between two points that are joined, with both.
  virtual std::vector<Point> leg(Point from, Point to) const = 0;
};

}  // namespace lasius
