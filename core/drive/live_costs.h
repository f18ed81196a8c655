// The costs of a map that is edited, and the cheapest walk over them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/cost/goal_field.h"
#include "core/cost/terrain.h"
#include "core/disc/disc_space.h"
#include "core/drive/edited_map.h"
#include "core/drive/pending_parts.h"
#include "lasius/cost/field.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// Weights of given costs and of the inflation of a map's blocked cells, and what a walk to a goal
/// costs over them. Told of an edit, it looks at what that reaches, when it is asked.
class LiveCosts {
 public:
  /// @param map      outlives the object
  /// @param corners  of walks: forbid, or allow where they squeeze between blocked cells
  /// @throws Error(invalid_parameter) for costs of another size, an inflation out of range, and
  /// where both together pass CostField::kMost.
  LiveCosts(const EditedMap& map, const CostField& costs, const std::optional<Inflation>& inflation,
            Corners corners);

  /// Cells of the map became blocked or free, or of those where the robot may be.
  void edited(const Rectangle& part) { edited_.add(part); }
  /// The given costs of a rectangle inside the map are others. @throws Error(invalid_parameter), as
  /// the constructor, nothing changed.
  void set(const Rectangle& part, std::span<const double> weights);

  /// Where a robot goes, as Planner::plan has it, along walk(): the path is that of any angle,
  /// polished for the next 120 cells, if a disc can go along it. Start and goal are joined. What
  /// was not looked at when it was stopped is looked at by the next call.
  Result run(const Request& request, const disc::DiscSpace* space);
  /// The cells of the last run's walk by eight moves, the start first; empty where it was stopped.
  const std::vector<Cell>& walk() const noexcept { return walk_; }
  double cost() const noexcept { return cost_; }            ///< of the last run's path
  double walk_cost() const noexcept { return walk_cost_; }  ///< and walk
  /// Between neighbours; infinite where the robot may not be in both.
  double move_cost(Cell from, Cell to);
  const cost::Terrain& terrain() const noexcept { return terrain_; }  ///< as of the last run
  std::int64_t bytes() const noexcept;                                ///< memory held

 private:
  bool bring_up_to_date(Poller& poller);
  bool update(const Rectangle& edit, Poller& poller);
  std::vector<Point> polished(std::span<const Cell> walk, std::size_t most, Poller& poller) const;
  void find_path(const disc::DiscSpace* space, const StopCondition& stop, Poller& poller,
                 Result& result);
  double weight_of(Cell c, std::int32_t squared_half_cells) const noexcept;

  const EditedMap& map_;
  std::vector<double> given_;  // row by row
  double least_;               // of them
  std::optional<Inflation> inflation_;
  cost::Terrain terrain_;
  bool squeezes_;
  PendingParts edited_;
  std::vector<Cell> changed_;
  std::optional<cost::GoalField> field_;
  std::vector<Cell> walk_;
  double cost_ = 0, walk_cost_ = 0;
};

}  // namespace lasius
