// No way of a vehicle is shorter: what the disc in its footprint needs around the obstacles, and
// what the vehicle needs without them.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/disc/disc_cells.h"
#include "core/disc/disc_search.h"
#include "core/disc/disc_space.h"
#include "core/vehicle/made_once.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

/// Bounds on one map, for one vehicle. Thread-safe.
class Bound {
 public:
  /// The disc's space is made when it is first asked for.
  Bound(const Grid& grid, const Vehicle& vehicle);

  /// Of the way to any of the goals, cells. Stopped: a smaller one.
  double length(const Request& request) const;
  /// Proves that no goal can be reached. False says nothing.
  bool cut_off(const Request& request) const;

 private:
  /// Null where a disc is too small to have one, or stopped.
  const disc::DiscSpace* space(const StopCondition& stop) const;
  double around_obstacles(Point start, Point goal, const StopCondition& stop) const;

  const Vehicle& vehicle_;
  double radius_;
  Grid grid_;
  MadeOnce<disc::DiscSpace> space_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<disc::DiscSearch>> spare_;
};

}  // namespace lasius::vehicle
