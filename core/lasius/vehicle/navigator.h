// Planning for a vehicle that drives: the map changes under it, and each step asks for what is left
// of its way.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/cost/field.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

/// How a Navigator plans; as in Request.
struct NavigatorOptions {
  double goal_tolerance = 0;             ///< cells
  double heading_tolerance = 0;          ///< radians
  double weight = 1.5;                   ///< of the estimate of what is left
  bool smooth = true;                    ///< shorten what the search finds
  std::int64_t max_states = 20'000'000;  ///< a search gives up after so many
  /// Of the map's cells: then ways are the cheapest that are found, as those of a Planner over
  /// costs.
  std::optional<CostField> costs = {};
  /// Costs around what is blocked, on top of `costs`; they follow what is observed.
  std::optional<Inflation> inflation = {};
  /// After so many steps without a way walls count as free that were learned, and not observed
  /// again in these steps: what stood there may have gone. 0: never.
  int doubt_after = 16;
};

/// What is left from the vehicle on, certified as a plan is on the map as it is known now. No
/// lower_bound is told.
struct Way : Result {
  /// The way was planned in this step; else it is what is left of an earlier one.
  bool replanned = false;
  /// Where the vehicle meets what is blocked as it stands, so many of the first segments lead out
  /// of that: over them it meets no other cell than it meets where it stands.
  int way_out = 0;
  /// So many of the first segments lead from beside the way back to it.
  int rejoined = 0;
  /// So many walls were taken for free in this step: see NavigatorOptions::doubt_after.
  std::int64_t doubted = 0;
};

/// A planner that belongs to a vehicle, with one map. Its program tells the Navigator what it sees
/// (scans and points in metres: seen_cells()), and asks for the way again and again. The way is
/// kept as long as no wall that was learned is met by what its sweep has left, and no wall that has
/// gone could make it cheaper: a step then costs what has changed. With an inflation any change
/// near it has what is left compared with a new plan. A vehicle beside its way, by what its
/// localisation makes of it, is led back to it by a certified motion; one with a curvature_rate,
/// for which there is hardly such a motion, by a new plan.
///
/// Not thread-safe. Deterministic in the sequence of calls.
class LASIUS_EXPORT Navigator {
 public:
  /// Goals as in Request. They and the vehicle may touch what is blocked: the answer tells.
  /// @throws Error(invalid_parameter) as validate(Vehicle) and CostField::add, for costs of a map
  /// of another size, and where there is no goal
  Navigator(Grid map, const Vehicle& vehicle, std::vector<Pose> goals,
            const NavigatorOptions& options = {});
  ~Navigator();
  Navigator(Navigator&&) noexcept;  ///< one that was moved from may only be assigned to or end
  Navigator& operator=(Navigator&&) noexcept;

  /// Each of these cells is blocked, or free. What lies outside the map is ignored.
  void observe(std::span<const Cell> cells, bool blocked);
  /// Likewise all cells of a rectangle.
  void observe(const Rectangle& part, bool blocked);
  /// In place of NavigatorOptions::costs: from the next step on the cheapest way over these is
  /// looked for, and Way::cost is by them. The way that is kept stays where none is found that is
  /// cheaper.
  /// @throws Error(invalid_parameter) for costs of a map of another size
  void set_costs(CostField costs);

  /// The way from where the vehicle is. Never throws for what the world is like: without a way
  /// `status` and `error` tell why, and the next step may find one. Holds until the next call that
  /// is not const. A step that is stopped goes on with the way that it has, where that holds.
  /// @throws Error(invalid_parameter) for numbers that Request refuses
  const Way& step(const Pose& robot, const StopCondition& stop = {});

  /// What motions cost as the last plan was made: see Planner::cost.
  double cost(std::span<const Segment> segments) const;
  std::span<const Pose> goals() const noexcept;  ///< where it leads
  void set_goals(std::vector<Pose> goals);       ///< the way is planned anew
  void forget();                                 ///< the way kept so far is planned anew
  const Grid& map() const noexcept;              ///< as it is known now

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lasius::vehicle
