// The search for cheap routes.
#pragma once

#include <cstdint>
#include <functional>

#include "core/tour/routes/routes.h"
#include "lasius/base/stop.h"

namespace lasius::tour {

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
/// is cheapest there (Smith & Imeson 2017, GLNS, without its adaptive choices); dearer
/// solutions are accepted at a temperature that falls in each generation. Several routes begin with
/// shares of one tour over all, where these are cheaper. Between generations find_order orders each
/// route's stops anew, and best_members chooses them anew. Deterministic, but for when it is
/// stopped.
RoutesFound find_routes(const RouteProblem& problem, const Costs& costs,
                        const RouteOptions& options);

}  // namespace lasius::tour
