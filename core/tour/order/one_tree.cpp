#include "core/tour/order/one_tree.h"

#include <algorithm>

namespace lasius::tour {

OneTree::OneTree(const Costs& costs, std::span<const Point> places, int candidates, Poller& poller)
    : price(costs.size(), 0),
      costs_(costs),
      candidates_(costs, places, candidates, poller),
      parent_(costs.size()),
      degree_(costs.size()),
      key_(costs.size()) {
  add({});
}

void OneTree::add(std::span<const std::pair<int, int>> more) {
  candidates_.add(costs_, more);
  extra.assign(candidates_.count(), 0);
}

// The spanning tree over the candidates; false where these do not join all.
bool OneTree::span() {
  const int n = costs_.size();
  std::fill(key_.begin(), key_.end(), kFar);
  std::fill(degree_.begin(), degree_.end(), 0);
  in_.assign(n, 0);
  heap_.assign(1, {0, 0, -1, 0});
  tree_.clear();
  reached_.clear();
  while (!heap_.empty() && static_cast<int>(reached_.size()) < n) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Waiting now = heap_.back();
    heap_.pop_back();
    if (in_[now.to]) continue;
    in_[now.to] = 1;
    reached_.push_back(now.to);
    parent_[now.to] = now.from;
    if (now.from >= 0) {
      tree_.push_back(now.leg);
      ++degree_[now.to];
      ++degree_[now.from];
    }
    for (const auto& leg : candidates_.of(now.to)) {
      if (in_[leg.to]) continue;
      const std::size_t at = index(leg);
      const Sum key = priced(leg.cost, now.to, leg.to) + extra[at];
      if (key >= key_[leg.to]) continue;
      key_[leg.to] = key;
      heap_.push_back({key, leg.to, now.to, at});
      std::push_heap(heap_.begin(), heap_.end());
    }
  }
  return static_cast<int>(reached_.size()) == n;
}

Sum OneTree::sparse() {
  if (!span()) return kFar;
  const int n = costs_.size();
  Sum value = 0, second = -kFar;
  for (std::size_t i = 1; i < reached_.size(); ++i) value += key_[reached_[i]];
  int leaf = -1;
  const Candidates::Leg* closing = nullptr;
  for (int v = 0; v < n; ++v) {
    if (degree_[v] != 1) continue;
    Sum least = kFar;
    const Candidates::Leg* by = nullptr;
    for (const auto& leg : candidates_.of(v)) {
      if (parent_[v] == leg.to || parent_[leg.to] == v) continue;
      const Sum key = priced(leg.cost, v, leg.to) + extra[index(leg)];
      if (key < least) least = key, by = &leg;
    }
    if (by != nullptr && least > second) second = least, leaf = v, closing = by;
  }
  if (closing == nullptr) return kFar;
  ++degree_[leaf];
  ++degree_[closing->to];
  tree_.push_back(index(*closing));
  return value + second;
}

Sum OneTree::dense(Pairs& more) const {
  const int n = costs_.size();
  std::vector<Sum> key(n, kFar), more_of(n, 0);  // what legs from one stop cost more
  std::vector<int> from(n, -1), degree(n, 0);
  std::vector<char> in(n, 0);
  const auto mark = [&](int v, bool known) {
    for (const auto& leg : candidates_.of(v)) more_of[leg.to] = known ? extra[index(leg)] : 0;
  };
  Sum value = 0;
  for (int count = 0, now = 0; count < n; ++count) {
    if (count > 0) {
      now = -1;
      for (int v = 0; v < n; ++v)
        if (!in[v] && (now < 0 || key[v] < key[now])) now = v;
      value += key[now];
      ++degree[now];
      ++degree[from[now]];
      let_in(now, from[now], more);
    }
    in[now] = 1;
    mark(now, true);
    for (int v = 0; v < n; ++v) {
      if (in[v]) continue;
      const Sum to = priced(costs_.lower(now, v), now, v) + more_of[v];
      if (to < key[v]) key[v] = to, from[v] = now;
    }
    mark(now, false);
  }
  Sum second = -kFar;
  int leaf = -1, leaf_to = -1;
  for (int v = 0; v < n; ++v) {
    if (degree[v] != 1) continue;
    Sum least = kFar;
    int to = -1;
    mark(v, true);
    for (int w = 0; w < n; ++w) {
      if (w == v || from[v] == w || from[w] == v) continue;
      const Sum leg = priced(costs_.lower(v, w), v, w) + more_of[w];
      if (leg < least) least = leg, to = w;
    }
    mark(v, false);
    if (least > second) second = least, leaf = v, leaf_to = to;
  }
  let_in(leaf, leaf_to, more);
  return value + second;
}

void OneTree::let_in(int a, int b, Pairs& more) const {
  for (const auto& leg : candidates_.of(a))
    if (leg.to == b) return;
  more.emplace_back(a, b);
}

void OneTree::near(int count, Poller& poller, Pairs& more) {
  if (!span()) return;
  const int n = costs_.size();
  std::vector<Sum> dearest(n);  // leg of the tree on the way from a stop
  std::vector<char> on_way(n, 0), known(n, 0);
  std::vector<std::pair<Sum, int>> row;
  for (int u = 0; u < n && !poller.stop_after(n); ++u) {
    std::fill(on_way.begin(), on_way.end(), 0);
    dearest[u] = -kFar;
    on_way[u] = 1;
    for (int v = u; parent_[v] >= 0; v = parent_[v]) {
      dearest[parent_[v]] = std::max(dearest[v], key_[v]);
      on_way[parent_[v]] = 1;
    }
    for (const int v : reached_)
      if (!on_way[v]) dearest[v] = std::max(dearest[parent_[v]], key_[v]);
    row.clear();
    for (const auto& leg : candidates_.of(u)) known[leg.to] = 1;
    for (int v = 0; v < n; ++v)
      if (v != u && !known[v]) row.emplace_back(priced(costs_.lower(u, v), u, v) - dearest[v], v);
    for (const auto& leg : candidates_.of(u)) known[leg.to] = 0;
    const auto nearest = row.begin() + std::min<std::ptrdiff_t>(count, std::ssize(row));
    std::partial_sort(row.begin(), nearest, row.end());
    for (auto leg = row.begin(); leg != row.end(); ++leg)
      if (leg < nearest || leg->first < 0) more.emplace_back(u, leg->second);
  }
}

}  // namespace lasius::tour
