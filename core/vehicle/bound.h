// No way of a vehicle is shorter: what the disc in its footprint needs around the obstacles, with
// what the vehicle's headings at its ends come to, and what the vehicle needs without obstacles.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/cost/terrain.h"
#include "core/disc/disc_cells.h"
#include "core/disc/disc_search.h"
#include "core/disc/disc_space.h"
#include "core/vehicle/made_once.h"
#include "core/vehicle/prices.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

/// Bounds on one map, for one vehicle. Thread-safe.
class Bound {
 public:
  /// The disc's space is made when it is first asked for.
  Bound(const Grid& grid, const Vehicle& vehicle, const Prices& prices);

  /// Of the length of the way to any of the goals, cells, or over weights of what Prices has it
  /// cost. There is one. Stopped, or not `around` the obstacles: a smaller one.
  double least(const Request& request, bool around = true) const;
  /// The bound as it is told of a path: at most what the path has, which it may be above by
  /// rounding, and over weights by what the chords are beside the arcs. None where it is above by
  /// more: then one of both is wrong.
  static std::optional<double> told(double bound, double reached, bool weighted) noexcept;
  /// Proves that no goal can be reached. False says nothing.
  bool cut_off(const Request& request) const;

 private:
  /// Null where a disc is too small to have one, or stopped.
  const disc::DiscSpace* space(const StopCondition& stop) const;
  /// @param turned  by which the goal's heading may differ
  double around_obstacles(const Pose& start, const Pose& goal, double turned,
                          const StopCondition& stop) const;
  double open_around(const disc::DiscSpace& disc, Point p) const;
  double over_weights(Point start, Point goal, bool joined, const StopCondition& stop) const;

  const Vehicle& vehicle_;
  const Prices& prices_;
  double radius_;
  Grid grid_;
  MadeOnce<disc::DiscSpace> space_;
  MadeOnce<cost::Terrain> terrain_;  ///< the cells where the reference point may be
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<disc::DiscSearch>> spare_;
};

}  // namespace lasius::vehicle
