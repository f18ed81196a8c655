#include "core/tour/order/subset_dp.h"

#include <algorithm>
#include <limits>

namespace lasius::tour {

std::vector<int> subset_order(const Costs& costs, const Ends& ends) {
  const int n = costs.size();
  std::vector<double> exact(static_cast<std::size_t>(n) * n);  // sums of so few are
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) exact[a * n + b] = exact[b * n + a] = costs(a, b);
  return subset_order(n, exact, ends);
}

std::vector<int> subset_order(int n, const std::vector<double>& lengths, const Ends& ends) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (n == 1) return {0};
  // A closed tour begins anywhere: at the start, or at stop 0.
  const int first = ends.open ? ends.start : std::max(ends.start, 0);
  const unsigned all = (1u << n) - 1;
  // least[subset * n + v]: of all ways over the subset that end at v.
  std::vector<double> least((all + std::size_t{1}) * n, kNone);
  for (int v = 0; v < n; ++v)
    if (first < 0 || v == first) least[(std::size_t{1} << v) * n + v] = 0;
  for (unsigned subset = 1; subset <= all; ++subset)
    for (int v = 0; v < n; ++v) {
      const double here = least[subset * n + v];
      if (here == kNone) continue;
      for (int w = 0; w < n; ++w) {
        if (subset >> w & 1) continue;
        double& there = least[(subset | 1u << w) * n + w];
        there = std::min(there, here + lengths[v * n + w]);
      }
    }
  int last = -1;
  double best = kNone;
  for (int v = 0; v < n; ++v) {
    if (ends.open && ends.goal >= 0 && v != ends.goal) continue;
    double sum = least[all * n + v];
    if (!ends.open) sum += lengths[v * n + first];
    if (sum < best) best = sum, last = v;
  }
  std::vector<int> order(n);
  unsigned subset = all;
  for (int at = n - 1; at >= 0; --at) {
    order[at] = last;
    const unsigned before = subset & ~(1u << last);
    for (int v = 0; v < n && at > 0; ++v)
      if ((before >> v & 1) &&
          least[before * n + v] + lengths[v * n + last] == least[subset * n + last]) {
        last = v;
        break;
      }
    subset = before;
  }
  return order;
}

}  // namespace lasius::tour
