// What every planner of the comparison looks like, ours and the peers alike.
#pragma once

#include <limits>
#include <vector>

#include "lasius/grid/grid.h"

namespace lasius::peers {

inline constexpr double kNoPath = std::numeric_limits<double>::infinity();

/// A planner made ready for one map: the constructor is the per-map preparation, and scratch memory
/// is kept from query to query. The grid must outlive it. Not for use from several threads at once.
class QueryPlanner {
 public:
  virtual ~QueryPlanner() = default;
  /// Plans between the centres of two free cells. Returns the length in cells, kNoPath where there
  /// is none; `path` becomes the polyline from start to goal (empty without a path).
  virtual double plan(Cell start, Cell goal, std::vector<Point>& path) = 0;
  /// What the preparation keeps for the map, in bytes; not a number where nobody counts.
  virtual double prepared_bytes() const { return std::numeric_limits<double>::quiet_NaN(); }

 protected:
  QueryPlanner() = default;
  QueryPlanner(const QueryPlanner&) = default;
  QueryPlanner& operator=(const QueryPlanner&) = default;
};

}  // namespace lasius::peers
