// Planners over costs as they are in use, each in its plain form.
#pragma once

#include <memory>

#include "bench/peers/query_planner.h"
#include "bench/peers/weighted_map.h"

namespace lasius::peers {

/// Each plans on a map that outlives it. Returned is what the planner itself holds its path to
/// cost, which for the fields is not the integral along it.
std::unique_ptr<QueryPlanner> cost_heap_astar(const WeightedMap& map);
std::unique_ptr<QueryPlanner> cost_bucket_astar(const WeightedMap& map);
std::unique_ptr<QueryPlanner> cost_theta_star(const WeightedMap& map);
std::unique_ptr<QueryPlanner> field_dstar(const WeightedMap& map);
std::unique_ptr<QueryPlanner> fast_marching(const WeightedMap& map);

}  // namespace lasius::peers
