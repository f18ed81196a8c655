// The search for an order that is given in part: windows of the best tour are built again.
#pragma once

#include "core/tour/order/partial_order.h"
#include "core/tour/order/search.h"

namespace lasius::tour {

/// Iterated local search: each step takes the current path and either lets four short pieces change
/// places, or builds a window of any length again, mostly as it was, else by drawing near nodes;
/// PathExchange follows. Dearer paths are accepted at a temperature that falls to 0 with the
/// horizon: the deadline where there is one, else a number of steps by `generations`. Of more than
/// 12 stops. `order` is empty where no order keeps the capacity, proven where `optimal`.
OrderFound find_partial_order(const Costs& costs, const Ends& ends, const PartialOrder& given,
                              const OrderOptions& options);

/// An order that breaks nothing of what is given, near ones first, and whether none is proven where
/// it is empty. Loads that are taken off go first; at most some thousands of choices are tried.
struct FirstOrder {
  std::vector<int> order;
  bool proven = false;
};
FirstOrder first_order(const Costs& costs, const Ends& ends, const PartialOrder& given);

}  // namespace lasius::tour
