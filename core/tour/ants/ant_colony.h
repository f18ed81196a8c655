// Orders of stops by the published ant colonies.
#pragma once

#include "core/tour/order/search.h"
#include "lasius/plan/search_result.h"
#include "lasius/tour/ants.h"

namespace lasius::tour {

/// Trails and weights of so many stops take 100 MB.
constexpr int kMostForAnts = 2000;

/// An order by a colony, and its course in `run`: deterministic, whatever the threads, but for when
/// it is stopped. Of costs that differ with their direction ants lay their trail one way. Of
/// `options` kicks and generations are not read. Nothing that no ant found is answered: where an
/// order is given in part ants step to stops alone that it allows, and their tours are improved by
/// exchanges of pieces alone.
/// @throws Error(invalid_parameter) for parameters that validate() refuses, more stops than
/// kMostForAnts, and as find_order.
OrderFound find_order_by_ants(const Costs& costs, const Ends& ends, bool symmetric,
                              const AntParams& params, int threads, const OrderOptions& options,
                              Convergence& run);

}  // namespace lasius::tour
