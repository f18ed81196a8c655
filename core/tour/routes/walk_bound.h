// What no tour of groups is cheaper than, by walks that may come back to a task.
#pragma once

#include <cstdint>

#include "core/base/poller.h"
#include "core/tour/routes/routes.h"

namespace lasius::tour {

/// A whole number that no solution of a problem with one route is cheaper than; `upper` is the cost
/// of one. Ascent over prices of tasks; each value is the cheapest walk of as many stops as there
/// are tasks, by dynamic programming, that forgets which tasks it did but for those near to all
/// stops since (ng-routes, Baldacci, Mingozzi & Roberti 2011). So a walk may do a task twice, but
/// comes to a task and goes on at one stop, where trees do not: on maps and of scattered groups it
/// is the better bound. Takes 1.5e9 steps and 100 MB at most; 0 of several routes, of fewer than 3
/// tasks, where that is not enough, and stopped before there was a value.
std::int64_t walk_bound(const RouteProblem& problem, const Costs& costs, std::int64_t upper,
                        Poller& poller);

}  // namespace lasius::tour
