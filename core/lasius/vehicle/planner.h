// Plans for vehicles: exact ends, motions that are certified over their whole sweep, a bound.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lasius/base/status.h"
#include "lasius/base/stop.h"
#include "lasius/cost/field.h"
#include "lasius/export.h"
#include "lasius/grid/grid.h"
#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/space.h"
#include "lasius/vehicle/vehicle.h"

namespace lasius::vehicle {

/// What is asked.
struct Request {
  Pose start;                    ///< met exactly
  std::vector<Pose> goals;       ///< at least one; the cheapest to reach of those found is met
  double goal_tolerance = 0;     ///< cells: a path may end so far from a goal's point
  double heading_tolerance = 0;  ///< radians: and turned so far from its yaw; pi or more: any yaw
  /// At least 1: of the estimate of what is left. A larger one is sooner done; the estimate is not
  /// always below what is left, and the cost may be more than that factor above the lattice's best.
  double weight = 1.5;
  bool smooth = true;  ///< shorten what the search finds
  bool bound = true;   ///< tell lower_bound
  /// At most so many states of the lattice, 32 bytes each: 16 for each cell that is entered, twice
  /// that with a price for cusps.
  std::int64_t max_states = 20'000'000;
  /// Ends the search with the best path so far.
  StopCondition stop = {};
};

/// What is answered.
struct Result {
  /// solved; limit and interrupted, perhaps with a path; unreachable: proven, the disc inside the
  /// footprint cannot get there; no_path: none in the part of the lattice that was searched, which
  /// proves nothing; invalid: the vehicle touches something at the start, or at every goal.
  Status status = Status::no_path;
  Fault fault = Fault::none;    ///< of invalid and unreachable
  std::optional<Cell> touched;  ///< of invalid: what is met at that end
  std::string error;            ///< where there is no path: why, in a sentence
  /// From the start to the goal, each begins where one ends; the first yaw is the start's in
  /// [-pi, pi].
  std::vector<Segment> segments;
  int goal = -1;      ///< index of the goal that is met
  double length = 0;  ///< driven, cells
  double cost = 0;    ///< by the vehicle's prices, cells; over costs as Planner::cost has it
  int cusps = 0;      ///< changes between forwards and backwards
  /// Of a vehicle with a curvature_rate: where the curvature jumps nevertheless, since no blend has
  /// room there; SpeedLimits::steady_curvature lets it rest at them.
  int corners = 0;
  /// No way of this vehicle, on this map, from the start to any of the goals is shorter, cells: the
  /// greatest of that of the disc inside the footprint around the obstacles and that of the vehicle
  /// without obstacles. Over costs none costs less: the greatest of what the disc's cheapest path
  /// costs, and of the vehicle's length without obstacles times the least weight. None where it was
  /// not asked for, or does not agree with the path.
  std::optional<double> lower_bound;
  bool over_costs = false;  ///< lower_bound and gap() are of the cost
  /// (length - lower_bound) / lower_bound, over costs of the cost; 0 where both are 0.
  LASIUS_EXPORT std::optional<double> gap() const;
  std::int64_t expanded = 0;  ///< states of the lattice
  std::int64_t checked = 0;   ///< motions that were certified or refused
};

/// Plans on one map for one vehicle; what depends on these is prepared once. Paths are checked once
/// more before they are answered. Thread-safe; the same request has the same answer bit for bit,
/// unless stopped.
class LASIUS_EXPORT Planner {
 public:
  /// @throws Error as validate(Vehicle)
  Planner(const Grid& grid, const Vehicle& vehicle);
  /// Over costs: the cheapest path is looked for. 24 bytes a cell. Where all free cells have one
  /// weight the paths are those without.
  /// @throws as above, and Error(invalid_parameter) for costs of a map of another size
  Planner(const Grid& grid, const Vehicle& vehicle, const CostField& costs);
  /// The same, or empty if stopped. @param costs  null: none
  [[nodiscard]] static std::optional<Planner> make(const Grid& grid, const Vehicle& vehicle,
                                                   const StopCondition& stop,
                                                   const CostField* costs = nullptr);
  /// Of the same vehicle on another map: what depends on the vehicle alone is shared. Empty if
  /// stopped. @param costs  null: none
  [[nodiscard]] std::optional<Planner> on(const Grid& grid, const StopCondition& stop = {},
                                          const CostField* costs = nullptr) const;
  Planner(const Planner&) noexcept;
  Planner& operator=(const Planner&) noexcept;
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;
  ~Planner();

  /// The map as the vehicle sees it; of one with a curvature_rate, which is given wider turns.
  const Space& space() const noexcept;
  bool over_costs() const noexcept;  ///< whether it was given costs
  /// What a path costs: the integral of the weight along the reference point's path, times
  /// `reverse_cost` backwards, turns in place and changes of gear as the lengths that the vehicle
  /// prices them with, in the cell where they happen. Arcs are taken as chords no farther than
  /// 0.001 cells from them, and as long as they are. Without costs as cost(Vehicle, segments).
  double cost(std::span<const Segment> segments) const;
  /// @throws Error(invalid_parameter) where a number is out of range or there is no goal
  [[nodiscard]] Result plan(const Request& request) const;
  /// What Result::lower_bound is of a way, before one is planned; infinite where it is proven that
  /// there is none. `around`: with regard to obstacles; of stops of a tour both parts are asked for
  /// apart. Smaller where stopped. @throws as plan
  [[nodiscard]] double lower_bound(const Request& request, bool around = true) const;
  /// Whether it is proven, by the regions of the disc inside the footprint, that no goal can be
  /// reached. False says nothing, as where it is stopped. @throws as plan
  [[nodiscard]] bool cut_off(const Request& request) const;

  class Impl;  ///< internal

 private:
  Planner() = default;
  bool prepare(const Grid& grid, const Vehicle& vehicle, const CostField* costs,
               const StopCondition& stop);
  std::shared_ptr<const Impl> impl_;
};

}  // namespace lasius::vehicle
