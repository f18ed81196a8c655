// The cheapest routes of few tasks.
#pragma once

#include <optional>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/routes/routes.h"

namespace lasius::tour {

constexpr int kMostTasksBySubsets = 12;

/// Cheapest routes by dynamic programming over subsets of tasks (Held & Karp 1962, with a state for
/// each stop of the last task), and then over what each route takes on. Nothing for more than
/// kMostTasksBySubsets tasks, where it would take more than 5e8 steps, and once stopped. Shortest
/// up to the rounding of sums. `lengths` are row by row of all `stops`.
std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem, int stops,
                                                          const std::vector<double>& lengths,
                                                          Poller& poller);
/// The same of costs; nothing of those that are priced late, all of which it would ask for.
std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem,
                                                          const Costs& costs, Poller& poller);

}  // namespace lasius::tour
