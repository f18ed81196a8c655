// What no routes are cheaper than.
#pragma once

#include <cstdint>

#include "core/base/poller.h"
#include "core/tour/routes/routes.h"

namespace lasius::tour {

/// A whole number that no solution is cheaper than; `upper` is the cost of one. The ascent of Held
/// & Karp (1970) over least trees of tasks, each leg at the stops where it is cheapest, with a
/// price for each stop, so that legs of a task are drawn to one stop. Routes with ends have one
/// depot, from which each stop is as near as from the nearest start, and as many legs back to it as
/// are cheapest. Of one route and tasks of several stops also walk_bound, the greater of both.
/// Takes 4 bytes a pair of stops, 16 of a stop and a task; 0 of fewer than 3 tasks of a ring, and
/// where nothing is known.
std::int64_t routes_bound(const RouteProblem& problem, const Costs& costs, std::int64_t upper,
                          Poller& poller);

/// The same of `open` routes or rings, the least cost itself where exact_routes finds it.
std::int64_t least_cost(const RouteProblem& problem, const Costs& costs, bool open,
                        std::int64_t upper, Poller& poller);

}  // namespace lasius::tour
