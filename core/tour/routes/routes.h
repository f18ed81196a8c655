// Orders of tasks in routes: a task is done at one of several stops, a route is a robot's.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/tour/order/costs.h"
#include "lasius/base/stop.h"

namespace lasius::tour {

/// What is asked.
struct RouteProblem {
  /// To each task the stops of which one does it, one at least. Starts and goals are in none.
  std::vector<std::vector<int>> tasks;
  /// One route at least. Where there are several each has a start, and none a goal.
  std::vector<Ends> routes;
  int most = 0;  ///< tasks of a route; 0: any number. Otherwise all routes have room for all tasks

  int size() const noexcept { return static_cast<int>(tasks.size()); }
  int room() const noexcept { return most > 0 ? most : size(); }
  /// A closed tour without a start.
  bool ring() const noexcept { return !routes.front().open && routes.front().start < 0; }
};

/// What came of it.
struct RoutesFound {
  std::vector<std::vector<int>> orders;  ///< stops, one list a route, with its start and goal
  std::int64_t cost = 0;
  bool optimal = false;                                     ///< proven, by subsets
  StopCondition::Cause cause = StopCondition::Cause::none;  ///< what ended it early
};

/// From stop to stop, order after order; closed ones also back.
inline std::vector<std::pair<int, int>> legs_of(const std::vector<std::vector<int>>& orders,
                                                bool open) {
  std::vector<std::pair<int, int>> legs;
  for (const std::vector<int>& order : orders) {
    const std::size_t n = order.size(), count = n < 2 ? 0 : open ? n - 1 : n;
    for (std::size_t i = 0; i < count; ++i) legs.emplace_back(order[i], order[(i + 1) % n]);
  }
  return legs;
}

/// The cost of a route, as cost_of.
inline std::int64_t cost_of(const Costs& costs, const std::vector<std::vector<int>>& orders,
                            bool open) {
  std::int64_t sum = 0;
  for (const auto& order : orders) sum += cost_of(costs, order, open);
  return sum;
}

}  // namespace lasius::tour
