// Planning for a robot that drives: the map changes under it, and each step asks for the next way.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/cost/field.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"
#include "lasius/plan/preparation.h"
#include "lasius/plan/result.h"

namespace lasius {

/// How a Navigator plans.
struct NavigatorOptions {
  Params params = {};  ///< the algorithm: `exact`, or any other
  /// Of the robot, a Disc, in cells: path and walk keep this far from blocked cells and from the
  /// outside. Paths are those of a Planner for it; walks go over cells whose centres keep the
  /// radius (for `exact` out of [0.05, 54] both are on the cells that grow_obstacles() leaves
  /// free). 0: a point.
  double radius = 0;
  /// Prepares the map, see Planner. After changes answers come from that where it is proven that
  /// they are right still, see Planner::edited, else from the ordinary search; a disc's graph goes
  /// with the first edit, as does a point's with the 1024th cell that has become free. For `exact`
  /// only.
  std::optional<PrepareOptions> prepare = {};
  double target_gap = 0;  ///< as in Request
  /// step() searches on every time; else only where the way has to be planned anew. For colonies
  /// only (Algorithm::Kind::colony).
  bool search_on = false;
  double goal_tolerance = 0;  ///< as in Request
  /// Of the map's cells: then the way is the cheapest that is found at once, and not the shortest,
  /// see Way::cost. For `exact`, without `prepare` and `target_gap`.
  std::optional<CostField> costs = {};
  /// Costs around what is blocked, on top of `costs`; they follow what is observed.
  std::optional<Inflation> inflation = {};
  /// After so many steps without a way walls count as free that were learned, and not observed
  /// again in these steps: what stood there may have gone. 0: never.
  int doubt_after = 16;
};

/// The way that a robot is to go on. Where it may not be, its cell blocked or too near to one that
/// is, path and walk lead first to the centre of a cell, `way_out`, by the fewest moves over free
/// cells of map().
struct Way : Result {
  /// The way was planned in this step; else it is the one of an earlier step, which still holds:
  /// `path` is what is left of it from the robot on, `length` that of this, and where the robot has
  /// moved nothing is certified; what else a Result tells is of the plan.
  bool replanned = false;
  /// The next cells, by moves to one of the eight neighbours, the robot's own first. They are cells
  /// that the planned path touches, or of a disc's path beside those. Some dozens of moves; the
  /// rest comes with later steps. Empty without a path. A disc's path may pass a door that no walk
  /// does, between centres of cells: then the path is the shortest walk over cells that leads to
  /// the goal, and where there is none, the robot's cell is alone here. Eight directions make it up
  /// to 8.3% longer than the path, which goes at any angle: a robot that can, follows `path`.
  std::vector<Cell> walk;
  /// Over costs: that of the path, from `way_out` on where there is one; else not a number. `walk`
  /// is the cheapest by eight moves over the cells that the robot may walk on, and goes on with
  /// every step; the path is made of it, cheaper by going at any angle; nothing is certified.
  double cost = std::numeric_limits<double>::quiet_NaN();
  /// Likewise of the cheapest walk, all of it.
  double walk_cost = std::numeric_limits<double>::quiet_NaN();
  /// So many walls were taken for free in this step: see NavigatorOptions::doubt_after.
  std::int64_t doubted = 0;
};

/// What drive() needs of a planner that belongs to a robot: a Navigator, or another to compare
/// with.
class LASIUS_EXPORT Pilot {
 public:
  virtual ~Pilot();
  /// All cells of a rectangle are blocked, or free. What lies outside the map is ignored.
  virtual void observe(const Rectangle& part, bool blocked) = 0;
  /// Each of these cells is blocked, or free. What lies outside the map is ignored.
  virtual void observe(std::span<const Cell> cells, bool blocked) = 0;
  /// The way to the goal from where the robot is now; without one, Status::unreachable or
  /// Status::invalid where that is proven. drive() asks for `status`, `path` (only whether it is
  /// empty), `walk`, `length`, `replanned`, `fault` and `error`. Holds until the next call of any
  /// member that is not const.
  virtual const Way& step(Cell robot, const StopCondition& stop = {}) = 0;

  virtual Cell goal() const noexcept = 0;  ///< where it leads
  /// The map as it is known now, the robot a point on it: obstacles are not grown here.
  virtual const Grid& map() const noexcept = 0;
  /// The cells that the robot may walk on: those whose centres keep its radius.
  virtual const Grid& passable() const noexcept = 0;
  /// True when the robot could get from one cell to the other, as far as is known.
  virtual bool connected(Cell a, Cell b) = 0;
  /// Of the robot, in cells: see NavigatorOptions. A point, unless overridden.
  virtual double radius() const noexcept { return 0; }
  /// Corners::allow where its walks squeeze past blocked cells. Corners::forbid, unless overridden.
  virtual Corners corners() const noexcept { return Corners::forbid; }
  /// See Request. 0, unless overridden.
  virtual double goal_tolerance() const noexcept { return 0; }
  /// What a move between neighbours costs, as far as is known; its length, unless overridden.
  virtual double move_cost(Cell from, Cell to);
  /// drive() calls it first: from then on it is drive() that doubts walls, by what the robot sees.
  /// Does nothing, unless overridden.
  virtual void begin_drive() {}
};

/// A planner that belongs to a robot, with one map. The robot's program tells the Navigator what
/// the robot sees, and asks for the next way, again and again. What an observation costs depends on
/// what has changed, not on the size of the map; the way is kept unless a change blocks it or could
/// shorten it.
///
/// The answers of `exact` are as short and as certain as a new Planner's. A colony goes on with the
/// pheromone that it has, repaired around the change; forget() makes it begin anew.
///
/// Not thread-safe: one thread at a time, save where a function says so. Deterministic in the
/// sequence of calls, as Planner::plan.
class LASIUS_EXPORT Navigator final : public Pilot {
 public:
  /// Labels the map's components, where the robot has a radius makes a disc's free space, and
  /// prepares the map if asked to. Start and goal may be blocked or outside: the answer tells.
  /// @throws Error(invalid_parameter) for parameters that validate() refuses, a radius or a gap out
  /// of range, options that are for other algorithms, and costs of another size or out of range.
  Navigator(Grid map, Cell goal, const NavigatorOptions& options = {});
  ~Navigator() override;
  Navigator(Navigator&&) noexcept;  ///< one that was moved from may only be assigned to or end
  Navigator& operator=(Navigator&&) noexcept;

  void observe(const Rectangle& part, bool blocked) override;
  void observe(std::span<const Cell> cells, bool blocked) override;

  /// The given costs of a rectangle inside the map are others now; inflation is added to them.
  /// @throws Error(invalid_parameter) for a Navigator without costs, a rectangle that leaves the
  /// map, and weights as CostField refuses them; then nothing has changed.
  void set_costs(const Rectangle& part, std::span<const double> weights);

  /// The way to the goal from where the robot is now. Never throws for what the world is like:
  /// Status::unreachable and Status::invalid (the goal has become blocked, or the robot's cell and
  /// no way leads out) are answers, and the next step may find another one.
  /// Holds until the next call of any member that is not const.
  const Way& step(Cell robot, const StopCondition& stop = {}) override;

  Cell goal() const noexcept override;  ///< may lie outside the map
  void set_goal(Cell goal);  ///< the trail of a colony that led to another goal is forgotten
  /// A colony's trail, and the way kept so far, are forgotten.
  void forget();

  const Grid& map() const noexcept override;
  const Grid& passable() const noexcept override;
  bool connected(Cell a, Cell b) override;
  double radius() const noexcept override;
  Corners corners() const noexcept override;  ///< of its paths, by its parameters
  double goal_tolerance() const noexcept override;
  double move_cost(Cell from, Cell to) override;
  void begin_drive() override;  ///< as with NavigatorOptions::doubt_after = 0 from then on
  /// What came of the visibility graph, as it was when made: edits of the map do not change it.
  /// State::none once it was dropped.
  Preparation preparation() const noexcept;
  std::int64_t bytes() const noexcept;  ///< memory held, a colony's trail not counted

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lasius
