#include "core/tour/order/recombine.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lasius::tour {

namespace {

constexpr int kMostChildren = 30;

// One of a stop's edges that are left to walk, taken out at both ends.
int take(std::vector<int> (&left)[2], int stop, bool second) {
  const int side = left[1][stop] >= 0 && (second || left[0][stop] < 0);
  const int to = left[side][stop];
  left[side][stop] = -1;
  left[left[0][to] == stop ? 0 : 1][to] = -1;
  return to;
}

}  // namespace

Recombiner::Recombiner(const Costs& costs, const Candidates& candidates)
    : costs_(&costs),
      candidates_(&candidates),
      sides_(costs.size()),
      even_(costs.size(), -1),
      odd_(costs.size(), -1) {
  for (auto* left : {left_a_, left_b_})
    for (int side = 0; side < 2; ++side) left[side].resize(costs.size());
}

void Recombiner::part(const ArrayTour& a, const ArrayTour& b, kernels::RandomStream& random) {
  const int n = a.size();
  circuits_.clear();
  std::vector<int> begins;
  for (int v = 0; v < n; ++v) {
    const int ap = a.previous(v), an = a.next(v), bp = b.previous(v), bn = b.next(v);
    left_a_[0][v] = ap == bp || ap == bn ? -1 : ap;
    left_a_[1][v] = an == bp || an == bn ? -1 : an;
    left_b_[0][v] = bp == ap || bp == an ? -1 : bp;
    left_b_[1][v] = bn == ap || bn == an ? -1 : bn;
    if (left_a_[0][v] >= 0 || left_a_[1][v] >= 0) begins.push_back(v);
  }
  for (int i = static_cast<int>(begins.size()); i > 1; --i)
    std::swap(begins[i - 1], begins[random.below(i)]);
  std::vector<int> path;
  for (const int begin : begins) {
    while (left_a_[0][begin] >= 0 || left_a_[1][begin] >= 0) {
      path.assign(1, begin);
      even_[begin] = 0;
      while (!path.empty()) {
        const int v = path.back();
        const bool by_a = path.size() % 2 == 1;
        const int to = take(by_a ? left_a_ : left_b_, v, random.next() >> 31);
        auto& place = by_a ? odd_ : even_;  // of stops that are left by an edge of the other tour
        const int size = static_cast<int>(path.size());
        if (place[to] < 0) {
          place[to] = size;
          path.push_back(to);
          continue;
        }
        const int from = place[to];
        Circuit circuit(path.begin() + from, path.end());
        for (int i = from + 1; i < size; ++i) (i % 2 == 0 ? even_ : odd_)[path[i]] = -1;
        path.resize(from + 1);
        if (by_a) std::rotate(circuit.begin(), circuit.end() - 1, circuit.end());
        circuits_.push_back(std::move(circuit));
        if (from == 0) {
          even_[begin] = -1;
          path.clear();
        }
      }
    }
  }
}

void Recombiner::replace(int stop, int from, int to) {
  touched_.push_back(stop);
  auto& [first, second] = sides_[stop];
  (first == from ? first : second) = to;
}

void Recombiner::restore(const ArrayTour& a) {
  for (const int v : touched_) sides_[v] = {a.previous(v), a.next(v)};
  touched_.clear();
}

int Recombiner::part_of(const ArrayTour& a, int stop) const {
  const auto cut = std::lower_bound(cuts_.begin(), cuts_.end(), a.place(stop));
  int piece = cut == cuts_.end() ? 0 : static_cast<int>(cut - cuts_.begin());
  while (part_[piece] != piece) piece = part_[piece];
  return piece;
}

// Exchanges the edges of a circuit; pieces of one part are those that its edges join.
bool Recombiner::build(const ArrayTour& a, const Circuit& circuit, std::int64_t& change) {
  const int edges = static_cast<int>(circuit.size());
  change = 0;
  cuts_.clear();
  for (int i = 0; i < edges; i += 2) {
    const int u = circuit[i], v = circuit[i + 1];
    cuts_.push_back(a.place(a.next(u) == v ? u : v));
    change -= a.next(u) == v ? a.to_next(u) : a.to_previous(u);
    replace(u, v, -1);
    replace(v, u, -1);
  }
  std::sort(cuts_.begin(), cuts_.end());
  const int pieces = static_cast<int>(cuts_.size());
  part_.resize(pieces);
  std::iota(part_.begin(), part_.end(), 0);
  size_.resize(pieces);
  for (int j = 0; j < pieces; ++j)
    size_[j] = j == 0 ? cuts_[0] - cuts_[pieces - 1] + a.size() : cuts_[j] - cuts_[j - 1];
  for (int i = 1; i < edges; i += 2) {
    const int u = circuit[i], v = circuit[i + 1 == edges ? 0 : i + 1];
    change += (*costs_)(u, v);
    replace(u, -1, v);
    replace(v, -1, u);
    const int pu = part_of(a, u), pv = part_of(a, v);
    if (pu == pv) continue;
    part_[pv] = pu;
    size_[pu] += size_[pv];
  }
  return join_parts(a, change);
}

bool Recombiner::join_parts(const ArrayTour& a, std::int64_t& change) {
  for (;;) {
    int smallest = -1, parts = 0;
    for (int j = 0; j < static_cast<int>(part_.size()); ++j)
      if (part_[j] == j) {
        ++parts;
        if (smallest < 0 || size_[j] < size_[smallest]) smallest = j;
      }
    if (parts == 1) return true;
    const int begin = a.at(cuts_[smallest]);
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    int bu = -1, bus = -1, bc = -1, bcs = -1;
    for (int u = begin, before = sides_[begin].first;;) {
      const auto sides = sides_[u];
      for (const auto& [c, cost] : candidates_->of(u)) {
        if (part_of(a, c) == smallest) continue;
        for (const int us : {sides.first, sides.second})
          for (const int cs : {sides_[c].first, sides_[c].second}) {
            const std::int64_t alone = std::int64_t{cost} - (*costs_)(u, us) - (*costs_)(c, cs);
            if (alone + costs_->lower(us, cs) >= best) continue;  // need not be priced
            const std::int64_t more = alone + (*costs_)(us, cs);
            if (more < best) best = more, bu = u, bus = us, bc = c, bcs = cs;
          }
      }
      const int on = sides.first == before ? sides.second : sides.first;
      before = u;
      u = on;
      if (u == begin) break;
    }
    if (bu < 0) return false;
    change += best;
    replace(bu, bus, bc);
    replace(bc, bcs, bu);
    replace(bus, bu, bcs);
    replace(bcs, bc, bus);
    const int other = part_of(a, bc);
    part_[smallest] = other;
    size_[other] += size_[smallest];
  }
}

bool Recombiner::improve(ArrayTour& a, const ArrayTour& b, kernels::RandomStream& random,
                         Poller& poller) {
  const int n = a.size();
  part(a, b, random);
  for (int v = 0; v < n; ++v) sides_[v] = {a.previous(v), a.next(v)};
  touched_.clear();
  std::int64_t best = 0;
  std::vector<std::pair<int, std::pair<int, int>>> changed;
  int children = 0;
  for (const Circuit& circuit : circuits_) {
    if (children++ == kMostChildren || poller.stop_after(n / 8 + 1)) break;
    std::int64_t change = 0;
    if (build(a, circuit, change) && change < best) {
      best = change;
      changed.clear();
      for (const int v : touched_) changed.emplace_back(v, sides_[v]);
    }
    restore(a);
  }
  if (best == 0) return false;
  for (const auto& [v, sides] : changed) sides_[v] = sides;
  std::vector<int> order{0};
  for (int before = sides_[0].first, v = 0; static_cast<int>(order.size()) < n;) {
    const int on = sides_[v].first == before ? sides_[v].second : sides_[v].first;
    before = v;
    order.push_back(v = on);
  }
  a = ArrayTour(*costs_, std::move(order));
  return true;
}

}  // namespace lasius::tour
