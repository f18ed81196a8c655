// The best order of few stops, by dynamic programming over subsets (Held & Karp 1962; Bellman
// 1962).
#pragma once

#include <vector>

#include "core/tour/order/costs.h"
#include "core/tour/order/partial_order.h"

namespace lasius::tour {

constexpr int kMostBySubsets = 12;  ///< stops for which find_order takes it

/// A cheapest order that breaks nothing of what is given; empty where there is none. Precondition:
/// 1 to 20 stops, ends within them. Takes 2^n n^2 steps (n times that for a closed tour without
/// start whose order is given in part) and 8 n 2^n bytes.
std::vector<int> subset_order(const Costs& costs, const Ends& ends, const PartialOrder& given = {});
/// The same of lengths, row by row from each stop, shortest up to the rounding of sums.
std::vector<int> subset_order(int size, const std::vector<double>& lengths, const Ends& ends,
                              const PartialOrder& given = {});

}  // namespace lasius::tour
