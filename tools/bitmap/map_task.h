// What questions on a bitmap have in common: `plan`, each query of `batch`, `drive`.
#pragma once

#include <optional>

#include "tools/bitmap/reasons.h"
#include "tools/record/task.h"

namespace lasius::tool {

class MapTask : public Task {
 public:
  const RunOptions& options() const override = 0;
  const Algorithm& algorithm() const override;
  std::string parameter(std::string_view name) const override;

  /// Of an invalid start or goal where it is, as it was given, what blocks it, and the free cell
  /// that is nearest; of two that are not joined what would join them.
  std::string error() const override;

  double shown(double length) const override { return map().length_in(options().frame, length); }
  std::string unit() const override { return in_metres() ? "m" : ""; }

  /// Of a path that begins with a way out or ends short of its goal, where.
  void remark() const override;

  std::pair<Json, Json> ends() const override;
  /// What blocks an invalid start or goal.
  void add_findings(Json& json) const override;
  void add_settings(Json& json) const override;

 protected:
  virtual const LoadedMap& map() const = 0;
  virtual const Place& start() const = 0;
  virtual const Place& goal() const = 0;
  virtual const std::optional<Cell>& nearest_free() const = 0;  ///< to an invalid start or goal
  virtual const std::optional<Cell>& nearest_reachable() const = 0;  ///< likewise
  virtual const std::optional<Cell>& goal_reached() const = 0;
  virtual std::optional<Point> way_out() const { return std::nullopt; }
  /// Of a path with a goal tolerance: where it ends.
  virtual Point path_end() const { return centre(*goal_reached()); }
  /// Where the path ends, where a goal tolerance was given.
  void add_goal_reached(Json& json) const;

  virtual const Remedy* remedy() const { return nullptr; }  ///< of ends that are not joined

  bool curved() const;  ///< paths are a disc's curves
  bool in_metres() const { return options().frame == Frame::world; }

 private:
  bool at_start() const;  ///< an invalid end is the start
  std::string invalid_text() const;
  std::string tolerance_text() const;
  double from_goal(Point at) const;      ///< cells
  double goal_tolerance() const;         ///< likewise
  std::string name_of(Cell cell) const;  ///< with its metres, where those are in use
};

}  // namespace lasius::tool
