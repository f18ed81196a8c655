#include "core/tour/order/bound.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "core/tour/order/one_more.h"

namespace lasius::tour {

namespace {

using Sum = std::int64_t;
constexpr Sum kScale = 256;  // of costs, so that prices of stops have fractions
constexpr Sum kFar = std::numeric_limits<Sum>::max() / 4;
constexpr int kBoundCandidates = 10;
constexpr int kMostTurns = 300;
// Trees without gain before steps are halved: so many stops in all, within limits; half as many in
// later rounds. In corridors a bound is lost where steps become short too soon.
constexpr int kIdleStops = 100'000, kLeastIdle = 50, kMostIdle = 500;
constexpr Sum kGapNotWorth = 100'000;  // of the tour: a gap that no round is worth
constexpr Sum kLeastGain = 20;         // a round that closes less of the gap is the last

class Ascent {
 public:
  Ascent(const Costs& costs, std::span<const Point> places, Poller& poller)
      : costs_(costs),
        candidates_(costs, places, kBoundCandidates),
        poller_(poller),
        price_(costs.size(), 0),
        best_(price_),
        parent_(costs.size()),
        key_(costs.size()),
        degree_(costs.size()) {
    candidates_.add(costs, {});
  }

  Candidates& candidates() { return candidates_; }

  // The greatest valid bound, scaled; 0 if stopped before there was one.
  Sum run(Sum upper, int rounds) {
    Sum bound = 0;
    for (int round = 0; round < rounds && !poller_.stopped(); ++round) {
      const Sum earlier = bound;
      ascend(upper * kScale, round);
      price_ = best_;
      std::vector<std::pair<int, int>> more;
      bound = std::max(bound, dense_tree(more));
      // Where legs wind, the prices of the ascent belie bounds that are straight: the legs of the
      // tree are priced until it takes no others.
      for (int turn = 0; costs_.priced_late() && turn < kMostTurns && !more.empty(); ++turn) {
        for (const auto& [a, b] : more) costs_(a, b);
        if (poller_.stop_after(Poller::kWords)) break;
        const Sum before = bound;
        auto known = std::move(more);
        more.clear();
        bound = std::max(bound, dense_tree(more));
        if (bound == before && more == known) break;
      }
      if ((bound + kScale - 1) / kScale >= upper) break;
      if (upper * kScale - bound <= upper * kScale / kGapNotWorth) break;
      if (more.empty() && (upper * kScale - bound) / kLeastGain > bound - earlier) break;
      candidates_.add(costs_, more);
    }
    return bound;
  }

 private:
  struct Waiting {
    Sum key;
    int to, from;
    bool operator<(const Waiting& o) const { return key != o.key ? key > o.key : to > o.to; }
  };
  Sum priced(Sum cost, int a, int b) const { return cost * kScale + price_[a] + price_[b]; }

  // The 1-tree over the candidates: a spanning tree, and the second leg of the leaf that has the
  // dearest one. Its scaled value; kFar where the candidates do not join all.
  Sum sparse_tree() {
    const int n = costs_.size();
    std::fill(key_.begin(), key_.end(), kFar);
    std::fill(degree_.begin(), degree_.end(), 0);
    std::vector<char>& in = in_;
    in.assign(n, 0);
    std::priority_queue<Waiting, std::vector<Waiting>> queue(std::less<Waiting>{},
                                                             std::move(heap_));
    Sum value = 0;
    int count = 0;
    queue.push({0, 0, -1});
    while (!queue.empty() && count < n) {
      const Waiting now = queue.top();
      queue.pop();
      if (in[now.to]) continue;
      in[now.to] = 1;
      ++count;
      parent_[now.to] = now.from;
      if (now.from >= 0) {
        value += now.key;
        ++degree_[now.to];
        ++degree_[now.from];
      }
      for (const auto& leg : candidates_.of(now.to)) {
        const Sum key = priced(leg.cost, now.to, leg.to);
        if (in[leg.to] || key >= key_[leg.to]) continue;
        key_[leg.to] = key;
        queue.push({key, leg.to, now.to});
      }
    }
    heap_.clear();
    if (count < n) return kFar;
    Sum second = -kFar;
    int leaf = -1, leaf_to = -1;
    for (int v = 0; v < n; ++v) {
      if (degree_[v] != 1) continue;
      Sum least = kFar;
      int to = -1;
      for (const auto& leg : candidates_.of(v)) {
        if (parent_[v] == leg.to || parent_[leg.to] == v) continue;
        const Sum key = priced(leg.cost, v, leg.to);
        if (key < least) least = key, to = leg.to;
      }
      if (to >= 0 && least > second) second = least, leaf = v, leaf_to = to;
    }
    if (leaf < 0) return kFar;
    ++degree_[leaf];
    ++degree_[leaf_to];
    value += second;
    for (const Sum price : price_) value -= 2 * price;
    return value;
  }

  // Steps of lambda (upper - value) / |g|^2 along g; lambda is halved after some without gain.
  void ascend(Sum upper, int round) {
    const int n = costs_.size();
    const int patience = std::clamp(kIdleStops / n, kLeastIdle, kMostIdle) / (round == 0 ? 1 : 2);
    Sum greatest = -kFar;
    int idle = 0;
    best_ = price_;
    for (double lambda = round == 0 ? 2 : 1; lambda > 1e-3;) {
      const Sum value = sparse_tree();
      if (value >= kFar || poller_.stop_after(16 * static_cast<Sum>(n))) return;
      if (value > greatest) {
        greatest = value;
        best_ = price_;
        idle = 0;
      } else if (++idle >= patience) {
        idle = 0;
        lambda /= 2;
        price_ = best_;
      }
      double squares = 0;
      for (int v = 0; v < n; ++v) {
        const int g = degree_[v] - 2;
        squares += g * g;
      }
      if (squares == 0 || value >= upper) return;
      const double step = lambda * static_cast<double>(upper - value) / squares;
      for (int v = 0; v < n; ++v) {
        const int g = degree_[v] - 2;
        price_[v] += static_cast<Sum>(step * g);
      }
    }
  }

  // The same tree over all legs, at their lower bounds: its value is a bound for every tour.
  // `more`: its legs that are no candidates.
  Sum dense_tree(std::vector<std::pair<int, int>>& more) {
    const int n = costs_.size();
    std::vector<Sum> key(n, kFar);
    std::vector<int> from(n, -1), degree(n, 0);
    std::vector<char> in(n, 0);
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
      for (int v = 0; v < n; ++v) {
        if (in[v]) continue;
        const Sum to = priced(costs_.lower(now, v), now, v);
        if (to < key[v]) key[v] = to, from[v] = now;
      }
    }
    Sum second = -kFar;
    int leaf = -1, leaf_to = -1;
    for (int v = 0; v < n; ++v) {
      if (degree[v] != 1) continue;
      Sum least = kFar;
      int to = -1;
      for (int w = 0; w < n; ++w) {
        if (w == v || from[v] == w || from[w] == v) continue;
        const Sum leg = priced(costs_.lower(v, w), v, w);
        if (leg < least) least = leg, to = w;
      }
      if (least > second) second = least, leaf = v, leaf_to = to;
    }
    let_in(leaf, leaf_to, more);
    value += second;
    for (const Sum price : price_) value -= 2 * price;
    return value;
  }

  void let_in(int a, int b, std::vector<std::pair<int, int>>& more) const {
    for (const auto& leg : candidates_.of(a))
      if (leg.to == b) return;
    more.emplace_back(a, b);
  }

  const Costs& costs_;
  Candidates candidates_;
  Poller& poller_;
  std::vector<Sum> price_, best_;
  std::vector<int> parent_;
  std::vector<Sum> key_;
  std::vector<int> degree_;
  std::vector<char> in_;
  std::vector<Waiting> heap_;
};

}  // namespace

std::int64_t tour_bound(const Costs& costs, const Ends& ends, std::span<const Point> places,
                        std::int64_t upper, int rounds, Poller& poller) {
  if (costs.size() < 2) return 0;
  if (costs.size() == 2) return std::int64_t{costs.lower(0, 1)} * (ends.open ? 1 : 2);
  const std::optional<OneMore> more =
      ends.open ? std::optional<OneMore>(std::in_place, costs, ends) : std::nullopt;
  const std::int64_t surplus = more ? more->surplus() : 0;
  Ascent ascent(more ? more->costs() : costs, places, poller);
  if (more) ascent.candidates().add(more->costs(), more->all_legs());
  const Sum bound = ascent.run(upper + surplus, rounds);
  if (bound <= surplus * kScale) return 0;
  return std::min(upper, (bound + kScale - 1) / kScale - surplus);
}

}  // namespace lasius::tour
