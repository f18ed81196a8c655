// The search for an order of stops: subsets where they are few, else kicks, then recombination.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/tour/order/candidates.h"
#include "core/tour/order/costs.h"
#include "core/tour/order/partial_order.h"
#include "lasius/base/stop.h"

namespace lasius::tour {

/// How long, and by what.
struct OrderOptions {
  std::uint64_t seed = 1;
  std::int64_t kicks = -1;  ///< of the first tour; -1: one a stop
  int generations = -1;     ///< of the colony that recombines, in all; -1: until stopped
  std::int64_t target = 0;  ///< a cost that ends the search
  /// All stops, from the start: told before any search. Empty: of costs that are priced late one
  /// that is short by their bounds, else none.
  std::vector<int> first = {};
  /// What is given of the order; null: nothing. Costs may then differ with their direction.
  const PartialOrder* given = nullptr;
  StopCondition stop = {};
  /// Told each cheaper order. False ends the search.
  std::function<bool(std::span<const int> order, std::int64_t cost)> observer = {};
};

/// What came of it.
struct OrderFound {
  std::vector<int>
      order;  ///< every stop once; from the start; empty where none keeps what is given
  std::int64_t cost = 0;
  bool optimal = false;  ///< proven, by subsets, or where there is no order
  StopCondition::Cause cause = StopCondition::Cause::none;  ///< what ended it early
};

/// @throws Error(invalid_parameter) for ends that are not among the stops or are the same, or a
/// goal of a closed tour.
void check_ends(int size, const Ends& ends);

/// A cheap order: deterministic, but for when it is stopped; then the best one so far. At least one
/// stop. `places`, one a stop, are where quadrants are told by; none without.
/// @throws as check_ends.
OrderFound find_order(const Costs& costs, const Ends& ends, std::span<const Point> places,
                      const OrderOptions& options);

}  // namespace lasius::tour
