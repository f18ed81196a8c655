#include "core/tour/order/subset_dp.h"

#include <algorithm>
#include <limits>

namespace lasius::tour {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct Way {
  std::vector<int> order;
  double length = kNone;
};

// A shortest way from `first` (-1: from any), and of a closed tour back to it.
Way way_from(int first, int n, const std::vector<double>& lengths, const Ends& ends,
             const PartialOrder& given) {
  std::vector<unsigned> before(n, 0);
  for (int v = 0; v < n; ++v)
    for (int w = 0; w < n; ++w)
      if (given.before(w, v)) before[v] |= 1u << w;
  const unsigned all = (1u << n) - 1;
  std::vector<std::int64_t> carried(all + std::size_t{1}, 0);
  for (unsigned subset = 1; subset <= all; ++subset)
    for (int v = 0; v < n; ++v)
      if (subset >> v & 1) carried[subset] += given.load(v);
  const auto allowed = [&](unsigned subset, int v) {
    return (before[v] & ~subset) == 0 && carried[subset | 1u << v] <= given.capacity();
  };
  // least[subset * n + v]: of all ways over the subset that end at v.
  std::vector<double> least((all + std::size_t{1}) * n, kNone);
  for (int v = 0; v < n; ++v)
    if ((first < 0 || v == first) && allowed(0, v)) least[(std::size_t{1} << v) * n + v] = 0;
  for (unsigned subset = 1; subset <= all; ++subset)
    for (int w = 0; w < n; ++w) {
      if ((subset >> w & 1) || !allowed(subset, w)) continue;
      double& there = least[(subset | 1u << w) * n + w];
      for (int v = 0; v < n; ++v)
        there = std::min(there, least[subset * n + v] + lengths[v * n + w]);
    }
  Way best;
  int last = -1;
  for (int v = 0; v < n; ++v) {
    if (ends.open && ends.goal >= 0 && v != ends.goal) continue;
    double sum = least[all * n + v];
    if (!ends.open) sum += lengths[v * n + first];
    if (sum < best.length) best.length = sum, last = v;
  }
  if (last < 0) return best;
  best.order.resize(n);
  unsigned subset = all;
  for (int at = n - 1; at >= 0; --at) {
    best.order[at] = last;
    const unsigned rest = subset & ~(1u << last);
    for (int v = 0; v < n && at > 0; ++v)
      if ((rest >> v & 1) &&
          least[rest * n + v] + lengths[v * n + last] == least[subset * n + last]) {
        last = v;
        break;
      }
    subset = rest;
  }
  return best;
}

}  // namespace

std::vector<int> subset_order(const Costs& costs, const Ends& ends, const PartialOrder& given) {
  const int n = costs.size();
  std::vector<double> exact(static_cast<std::size_t>(n) * n);  // sums of so few are
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      if (a != b) exact[a * n + b] = costs(a, b);
  return subset_order(n, exact, ends, given);
}

std::vector<int> subset_order(int n, const std::vector<double>& lengths, const Ends& ends,
                              const PartialOrder& given) {
  if (ends.open || ends.start >= 0 || given.any_order())  // a closed tour of any order: from 0
    return way_from(ends.open ? ends.start : std::max(ends.start, 0), n, lengths, ends, given)
        .order;
  Way best;
  for (int first = 0; first < n; ++first) {
    Way way = way_from(first, n, lengths, ends, given);
    if (way.length < best.length) best = std::move(way);
  }
  return best.order;
}

}  // namespace lasius::tour
