// Orders of tasks in routes: a task is done at one of several stops, a route is a robot's.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/costs.h"
#include "lasius/stop.h"

namespace lasius::tour {

constexpr int kMostTasksBySubsets = 12;  ///< for which exact_routes takes so many steps at most

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

/// The cost of a route, as cost_of.
inline std::int64_t cost_of(const Costs& costs, const std::vector<std::vector<int>>& orders,
                            bool open) {
  std::int64_t sum = 0;
  for (const auto& order : orders) sum += cost_of(costs, order, open);
  return sum;
}

/// Cheapest routes by dynamic programming over subsets of tasks (Held & Karp 1962, with a state for
/// each stop of the last task), and then over what each route takes on. Nothing for more than
/// kMostTasksBySubsets tasks, where it would take more than 5e8 steps, and once stopped. Shortest
/// up to the rounding of sums. `lengths` are row by row of all `stops`.
std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem, int stops,
                                                          const std::vector<double>& lengths,
                                                          Poller& poller);
/// The same of costs.
std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem,
                                                          const Costs& costs, Poller& poller);

/// The cheapest stops of tasks that are done in this order, by the shortest path through the layers
/// of their stops; `ring`: from the last back to the first. `from` and `to` are stops before the
/// first and behind the last, -1: none (of a ring not read).
std::vector<int> best_members(const Costs& costs, std::span<const std::vector<int>* const> layers,
                              bool ring, int from, int to);

/// How long, and by what.
struct RouteOptions {
  std::uint64_t seed = 1;
  int generations = 20;  ///< of so many steps each: 2000, and 20 a task
  std::int64_t target = 0;
  StopCondition stop = {};
  /// Told each cheaper solution. False ends the search.
  std::function<bool(const RoutesFound&)> observer = {};
};

/// Cheap routes: exact ones where exact_routes gives them. Else tasks are taken out, at random,
/// along a route or near to each other, and put back where they are cheapest, each by the stop that
/// is cheapest there (Smith & Imeson 2017, GLNS, without its adaptive choices); solutions that are
/// little dearer than the best are kept. Between generations find_order orders each route's stops
/// anew, and best_members chooses them anew. Deterministic, but for when it is stopped.
RoutesFound find_routes(const RouteProblem& problem, const Costs& costs,
                        const RouteOptions& options);

/// A whole number that no solution is cheaper than; `upper` is the cost of one. The ascent of Held
/// & Karp (1970) over least trees of tasks, each leg at the stops where it is cheapest, with a
/// price for each stop, so that legs of a task are drawn to one stop. Routes with ends have one
/// depot, from which each stop is as near as from the nearest start, and as many legs back to it as
/// are cheapest. Takes 4 bytes a pair of stops, 16 of a
/// stop and a task; 0 of fewer than 3 tasks of a ring, and where
/// nothing is known.
std::int64_t routes_bound(const RouteProblem& problem, const Costs& costs, std::int64_t upper,
                          Poller& poller);

}  // namespace lasius::tour
