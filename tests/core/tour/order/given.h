// Orders given in part for tests, from a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "core/tour/order/costs.h"
#include "core/tour/order/partial_order.h"
#include "kernels/base/random_stream.h"
#include "lasius/tour/tour.h"
#include "tests/core/tour/order/instances.h"
#include "tests/oracle/least_tour.h"

namespace lasius::tour {

/// Some of the pairs of a random order, and loads where there is a capacity.
struct Given {
  std::vector<Before> relation;
  std::vector<int> loads;
  std::int64_t capacity = PartialOrder::kUnlimited;
  PartialOrder order(int size) const { return {size, relation, loads, capacity}; }
};

inline Given random_given(int size, std::uint32_t seed, const Ends& ends) {
  kernels::RandomStream random(seed, 1, 0);
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  for (int i = size; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  Given given;
  const auto any_end = [&](int v) { return v == ends.start || v == ends.goal; };
  const int dense = 1 + random.below(size);
  for (int a = 0; a < size; ++a)
    for (int b = a + 1; b < size; ++b)
      if (random.below(2 * size) < dense && !any_end(order[a]) && !any_end(order[b]))
        given.relation.emplace_back(order[a], order[b]);
  if (random.chance(0.5)) {
    given.capacity = 1 + random.below(3);
    for (int v = 0; v < size; ++v) given.loads.push_back(random.below(4) - 2);
  }
  return given;
}

/// The least cost of an order with these ends that breaks nothing, by other means; infinite where
/// there is none.
inline double least_cost(const Costs& costs, const Ends& ends, const Given& given = {}) {
  TourRequest request;
  request.open = ends.open;
  if (ends.start >= 0) request.start = ends.start;
  if (ends.goal >= 0) request.goal = ends.goal;
  request.after.resize(given.relation.empty() ? 0 : costs.size());
  for (const auto& [a, b] : given.relation) request.after[b].push_back(a);
  request.load = given.loads;
  if (!given.loads.empty()) request.capacity = given.capacity;
  return oracle::LeastTour(request, legs_of(costs)).length();
}

/// Whether an order has these ends and breaks nothing, told by the relation itself.
inline bool kept(const std::vector<int>& order, const Given& given, const Ends& ends) {
  std::vector<std::size_t> position(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) position[order[p]] = p;
  for (const auto& [a, b] : given.relation)
    if (position[a] >= position[b]) return false;
  std::int64_t carried = 0;
  for (const int v : order)
    if (!given.loads.empty() && (carried += given.loads[v]) > given.capacity) return false;
  return (ends.start < 0 || order.front() == ends.start) &&
         (ends.goal < 0 || order.back() == ends.goal);
}

}  // namespace lasius::tour
