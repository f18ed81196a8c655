#include "core/tour/order/subset_dp.h"

#include <algorithm>
#include <limits>

namespace lasius::tour {

std::vector<int> subset_order(const Costs& costs, const Ends& ends) {
  using Total = std::int64_t;
  constexpr Total kNone = std::numeric_limits<Total>::max() / 4;
  const int n = costs.size();
  if (n == 1) return {0};
  // A closed tour begins anywhere: at the start, or at stop 0.
  const int first = ends.open ? ends.start : std::max(ends.start, 0);
  const unsigned all = (1u << n) - 1;
  // least[subset * n + v]: of all ways over the subset that end at v.
  std::vector<Total> least((all + std::size_t{1}) * n, kNone);
  for (int v = 0; v < n; ++v)
    if (first < 0 || v == first) least[(std::size_t{1} << v) * n + v] = 0;
  std::vector<std::vector<Cost>> leg(n, std::vector<Cost>(n));
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) leg[a][b] = leg[b][a] = costs(a, b);
  for (unsigned subset = 1; subset <= all; ++subset)
    for (int v = 0; v < n; ++v) {
      const Total here = least[subset * n + v];
      if (here >= kNone) continue;
      for (int w = 0; w < n; ++w) {
        if (subset >> w & 1) continue;
        Total& there = least[(subset | 1u << w) * n + w];
        there = std::min(there, here + leg[v][w]);
      }
    }
  int last = -1;
  Total best = kNone;
  for (int v = 0; v < n; ++v) {
    if (ends.open && ends.goal >= 0 && v != ends.goal) continue;
    Total sum = least[all * n + v];
    if (!ends.open) sum += leg[v][first];
    if (sum < best) best = sum, last = v;
  }
  std::vector<int> order(n);
  unsigned subset = all;
  for (int at = n - 1; at >= 0; --at) {
    order[at] = last;
    const unsigned before = subset & ~(1u << last);
    for (int v = 0; v < n && at > 0; ++v)
      if ((before >> v & 1) && least[before * n + v] + leg[v][last] == least[subset * n + last]) {
        last = v;
        break;
      }
    subset = before;
  }
  return order;
}

}  // namespace lasius::tour
