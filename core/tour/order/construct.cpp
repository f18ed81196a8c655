#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/tour/order/fragments.h"
#include "core/tour/order/local_search.h"

namespace lasius::tour {

std::vector<int> order_of(const Fragments& parts, const std::function<double(int, int)>& away) {
  const int n = static_cast<int>(parts.side.size());
  std::vector<int> ends;
  for (int v = 0; v < n; ++v)
    if (!parts.full(v)) ends.push_back(v);
  std::vector<int> order;
  std::vector<char> seen(n, 0);
  int at = ends.empty() ? 0 : ends.front();
  for (int before = -1;;) {
    order.push_back(at);
    seen[at] = 1;
    const auto& side = parts.side[at];
    const int on = side[0] >= 0 && side[0] != before && !seen[side[0]]   ? side[0]
                   : side[1] >= 0 && side[1] != before && !seen[side[1]] ? side[1]
                                                                         : -1;
    before = at;
    if (on >= 0) {
      at = on;
      continue;
    }
    if (static_cast<int>(order.size()) == n) return order;
    at = -1;
    double least = 0;
    for (const int e : ends) {
      if (seen[e]) continue;
      const double far = away(before, e);
      if (at < 0 || far < least) at = e, least = far;
    }
    before = -1;
  }
}

std::vector<int> savings_order(const Costs& costs, const Candidates& candidates) {
  const int n = costs.size();
  std::vector<Cost> away(n, 0);  // from the first stop; by the bound: a pricer would price all
  for (int v = 1; v < n; ++v) away[v] = costs.lower(0, v);
  std::vector<std::tuple<std::int64_t, int, int>> edges;
  for (int v = 1; v < n; ++v)
    for (const auto& leg : candidates.of(v))
      if (leg.to != 0)
        edges.emplace_back(std::int64_t{leg.cost} - away[v] - away[leg.to], std::min(v, leg.to),
                           std::max(v, leg.to));
  std::sort(edges.begin(), edges.end());
  Fragments parts(n);
  for (const auto& [cost, a, b] : edges)
    if (parts.joins(a, b)) parts.join(a, b);
  // By the lower bound: a pricer would price all of them.
  return order_of(parts, [&](int a, int b) { return costs.lower(a, b); });
}

std::vector<int> random_order(const Costs& costs, const Candidates& candidates,
                              kernels::RandomStream& random) {
  const int n = costs.size();
  std::vector<int> order, rest(n), index(n);  // `rest`: not visited yet
  std::iota(rest.begin(), rest.end(), 0);
  std::iota(index.begin(), index.end(), 0);
  int at = random.below(n);
  for (;;) {
    order.push_back(at);
    rest[index[at]] = rest.back();
    index[rest.back()] = index[at];
    rest.pop_back();
    index[at] = -1;
    if (rest.empty()) return order;
    double sum = 0;
    const auto weight = [](Cost cost) { return 1 / ((cost + 1.0) * (cost + 1.0)); };
    for (const auto& leg : candidates.of(at))
      if (index[leg.to] >= 0) sum += weight(leg.cost);
    double draw = sum * random.next() * 0x1p-32;
    int to = -1;
    for (const auto& leg : candidates.of(at)) {
      if (index[leg.to] < 0) continue;
      to = leg.to;
      if ((draw -= weight(leg.cost)) < 0) break;
    }
    if (to < 0) {
      // None is left: the nearest of a sample, or of all where a cost is at hand.
      const int tries = std::min<int>(static_cast<int>(rest.size()), 50);
      for (int i = 0; i < tries; ++i) {
        const int r = rest[random.below(static_cast<int>(rest.size()))];
        if (to < 0 || costs.lower(at, r) < costs.lower(at, to)) to = r;
      }
    }
    at = to;
  }
}

}  // namespace lasius::tour
