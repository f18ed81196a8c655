#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/tour/order/local_search.h"

namespace lasius::tour {

namespace {

// Paths that grow together: for each stop its neighbours, and for an end of a path the other end.
struct Fragments {
  explicit Fragments(int n) : side(n, {-1, -1}), other(n) {
    std::iota(other.begin(), other.end(), 0);
  }
  bool full(int v) const { return side[v][1] >= 0; }
  bool joins(int a, int b) const { return !full(a) && !full(b) && other[a] != b; }
  void join(int a, int b) {
    side[a][side[a][0] >= 0] = b;
    side[b][side[b][0] >= 0] = a;
    const int ea = other[a], eb = other[b];
    other[ea] = eb;
    other[eb] = ea;
  }
  std::vector<std::array<int, 2>> side;
  std::vector<int> other;
};

}  // namespace

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
    // By the lower bound: a pricer would price all of them.
    at = -1;
    for (const int e : ends)
      if (!seen[e] && (at < 0 || costs.lower(before, e) < costs.lower(before, at))) at = e;
    before = -1;
  }
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
