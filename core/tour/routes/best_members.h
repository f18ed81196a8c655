// The cheapest stops of tasks whose order is given.
#pragma once

#include <span>
#include <vector>

#include "core/tour/order/costs.h"

namespace lasius::tour {

/// The cheapest stops of tasks that are done in this order, by the shortest path through the layers
/// of their stops; `ring`: from the last back to the first. `from` and `to` are stops before the
/// first and behind the last, -1: none (of a ring not read).
std::vector<int> best_members(const Costs& costs, std::span<const std::vector<int>* const> layers,
                              bool ring, int from, int to);

}  // namespace lasius::tour
