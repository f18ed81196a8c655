#include "core/tour/order/bound.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "core/tour/order/ascend.h"
#include "core/tour/order/blossoms.h"
#include "core/tour/order/one_more.h"

namespace lasius::tour {

namespace {

constexpr int kBoundCandidates = 6;
constexpr int kMostTurns = 300;
// Trees without gain before steps are halved: so many stops in all, within limits, or a share.
constexpr int kIdleStops = 100'000, kLeastIdle = 50, kMostIdle = 500;
struct Pace {
  int share;
  double first, last;  // steps
};
// In corridors a bound is lost where steps become short too soon: where the quick pace leaves a
// wide gap the slow one follows. With blossoms small steps do.
constexpr Pace kQuick{8, 2, 0.02}, kSlow{1, 2, 1e-3}, kSmall{4, 0.5, 0.02};
constexpr Sum kWide = 60;  // of the tour
constexpr Sum kLeastGain =
    50;  // a round with small steps that closes less of the gap is a poor one
constexpr int kMostPoor = 6;
constexpr Sum kGapNotWorth = 100'000;                // of the tour: a gap that no round is worth
constexpr double kNewShare = 0.02, kNoShare = 0.01;  // of a tree, in the mean of all; of a leg

class Ascent {
 public:
  Ascent(const Costs& costs, std::span<const Point> places, Poller& poller)
      : costs_(costs),
        candidates_(costs, places, kBoundCandidates, poller),
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
    int poor = 0;
    Pace pace = rounds > 1 ? kQuick : kSlow;
    for (int round = 0; round < rounds && !poller_.stopped(); ++round) {
      const Sum earlier = bound;
      number_legs();
      keep();
      const int patience =
          std::clamp(kIdleStops / costs_.size(), kLeastIdle, kMostIdle) / pace.share;
      ascend(*this, upper * kScale, -kFar, {pace.first, pace.last, static_cast<double>(patience)});
      back();
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
      const Sum gap = upper * kScale - bound;
      poor = pace.share == kSmall.share && gap / kLeastGain > bound - earlier ? poor + 1 : 0;
      const bool slow = pace.share == kQuick.share && gap > upper * kScale / kWide;
      pace = slow ? kSlow : kSmall;
      if (slow) std::fill(price_.begin(), price_.end(), 0);
      const bool cut = !slow && separate();
      if (poor == kMostPoor || (more.empty() && !cut && !slow && cuts_.empty())) break;
      if (!more.empty()) candidates_.add(costs_, more);
    }
    return bound;
  }

  // For ascend().
  Sum value() {
    const Sum tree = sparse_tree();
    return poller_.stop_after(16 * static_cast<Sum>(costs_.size())) ? kFar : tree;
  }
  void keep() {
    best_ = price_;
    for (Cut& cut : cuts_) cut.best = cut.price;
  }
  void back() {
    price_ = best_;
    for (Cut& cut : cuts_) set_price(cut, cut.best);
  }
  double squares() {
    count_legs();
    double sum = 0;
    for (const int degree : degree_) sum += (degree - 2) * (degree - 2);
    for (const Cut& cut : cuts_) {
      const Sum g = cut.taken - cut.blossom.most();
      if (g > 0 || cut.price > 0) sum += static_cast<double>(g * g);
    }
    return sum;
  }
  bool move(double step) {
    for (int v = 0; v < costs_.size(); ++v) price_[v] += static_cast<Sum>(step * (degree_[v] - 2));
    for (Cut& cut : cuts_) {
      const Sum g = cut.taken - cut.blossom.most();
      if (g != 0)
        set_price(cut,
                  std::max<Sum>(0, cut.price + static_cast<Sum>(step * static_cast<double>(g))));
    }
    return true;
  }

 private:
  struct Waiting {
    Sum key;
    int to, from;
    std::size_t leg;
    bool operator<(const Waiting& o) const { return key != o.key ? key > o.key : to > o.to; }
  };
  // A blossom with its price, which its legs cost more.
  struct Cut {
    Blossom blossom;
    Sum price = 0, best = 0;
    std::vector<std::size_t> legs = {};  // candidates, both directions
    Sum taken = 0;                       // of the tree
  };
  Sum priced(Sum cost, int a, int b) const { return cost * kScale + price_[a] + price_[b]; }
  std::size_t index(const Candidates::Leg& leg) const { return &leg - candidates_.of(0).data(); }

  // Which legs are the same in the other direction, and which each blossom has.
  void number_legs() {
    const int n = costs_.size();
    const auto last = candidates_.of(n - 1);
    const std::size_t count = last.data() + last.size() - candidates_.of(0).data();
    back_.assign(count, 0);
    share_.assign(count, 0);
    extra_.assign(count, 0);
    shares_ = 0;
    for (int v = 0; v < n; ++v)
      for (const auto& leg : candidates_.of(v))
        for (const auto& other : candidates_.of(leg.to))
          if (other.to == v) back_[index(leg)] = index(other);
    of_leg_.assign(count, {});
    std::vector<char> in(n, 0);
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      Cut& cut = cuts_[c];
      cut.legs.clear();
      for (const int v : cut.blossom.handle) in[v] = 1;
      for (const int v : cut.blossom.handle)
        for (const auto& leg : candidates_.of(v))
          if (in[leg.to]) cut.legs.push_back(index(leg));
      for (const int v : cut.blossom.handle) in[v] = 0;
      for (const auto& [a, b] : cut.blossom.teeth)
        for (const auto& leg : candidates_.of(a))
          if (leg.to == b) cut.legs.push_back(index(leg)), cut.legs.push_back(back_[index(leg)]);
      for (const std::size_t leg : cut.legs) {
        of_leg_[leg].push_back(static_cast<int>(c));
        extra_[leg] += cut.price;
      }
    }
  }

  void set_price(Cut& cut, Sum price) {
    for (const std::size_t leg : cut.legs) extra_[leg] += price - cut.price;
    cut.price = price;
  }

  // What the tree takes: of each blossom, and of each leg on average.
  void count_legs() {
    shares_ = shares_ * (1 - kNewShare) + kNewShare;
    weight_ /= 1 - kNewShare;
    for (Cut& cut : cuts_) cut.taken = 0;
    for (const std::size_t leg : tree_) {
      share_[std::min(leg, back_[leg])] += weight_;
      for (const int c : of_leg_[leg]) ++cuts_[c].taken;
    }
    if (weight_ < 1e100) return;
    for (double& share : share_) share /= weight_;
    weight_ = 1;
  }

  // Drops blossoms that cost nothing, and finds others; false where there are none.
  bool separate() {
    std::erase_if(cuts_, [](const Cut& cut) { return cut.price == 0; });
    std::vector<SharedLeg> legs;
    for (int v = 0; v < costs_.size(); ++v)
      for (const auto& leg : candidates_.of(v)) {
        const double share = std::min(1.0, share_[index(leg)] * kNewShare / weight_ / shares_);
        if (share > kNoShare) legs.push_back({v, leg.to, share});
      }
    const std::size_t before = cuts_.size();
    for (Blossom& blossom : blossoms_of(costs_.size(), legs))
      if (std::none_of(cuts_.begin(), cuts_.end(),
                       [&](const Cut& cut) { return cut.blossom == blossom; }))
        cuts_.push_back({std::move(blossom)});
    return cuts_.size() > before;
  }

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
    queue.push({0, 0, -1, 0});
    tree_.clear();
    while (!queue.empty() && count < n) {
      const Waiting now = queue.top();
      queue.pop();
      if (in[now.to]) continue;
      in[now.to] = 1;
      ++count;
      parent_[now.to] = now.from;
      if (now.from >= 0) {
        value += now.key;
        tree_.push_back(now.leg);
        ++degree_[now.to];
        ++degree_[now.from];
      }
      for (const auto& leg : candidates_.of(now.to)) {
        if (in[leg.to]) continue;
        const std::size_t at = index(leg);
        const Sum key = priced(leg.cost, now.to, leg.to) + extra_[at];
        if (key >= key_[leg.to]) continue;
        key_[leg.to] = key;
        queue.push({key, leg.to, now.to, at});
      }
    }
    heap_.clear();
    if (count < n) return kFar;
    Sum second = -kFar;
    int leaf = -1, leaf_to = -1;
    std::size_t leaf_leg = 0;
    for (int v = 0; v < n; ++v) {
      if (degree_[v] != 1) continue;
      Sum least = kFar;
      const Candidates::Leg* by = nullptr;
      for (const auto& leg : candidates_.of(v)) {
        if (parent_[v] == leg.to || parent_[leg.to] == v) continue;
        const Sum key = priced(leg.cost, v, leg.to) + extra_[index(leg)];
        if (key < least) least = key, by = &leg;
      }
      if (by != nullptr && least > second)
        second = least, leaf = v, leaf_to = by->to, leaf_leg = index(*by);
    }
    if (leaf < 0) return kFar;
    ++degree_[leaf];
    ++degree_[leaf_to];
    tree_.push_back(leaf_leg);
    return value + second - told();
  }

  // What all prices are worth to a tour.
  Sum told() const {
    Sum sum = 0;
    for (const Sum price : price_) sum += 2 * price;
    for (const Cut& cut : cuts_) sum += cut.price * cut.blossom.most();
    return sum;
  }

  // The same tree over all legs, at their lower bounds: its value is a bound for every tour.
  // `more`: its legs that are no candidates.
  Sum dense_tree(std::vector<std::pair<int, int>>& more) {
    const int n = costs_.size();
    std::vector<Sum> key(n, kFar), more_of(n, 0);  // what cuts cost more, from one stop
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
      for (const auto& leg : candidates_.of(now)) more_of[leg.to] = extra_[index(leg)];
      for (int v = 0; v < n; ++v) {
        if (in[v]) continue;
        const Sum to = priced(costs_.lower(now, v), now, v) + more_of[v];
        if (to < key[v]) key[v] = to, from[v] = now;
      }
      for (const auto& leg : candidates_.of(now)) more_of[leg.to] = 0;
    }
    Sum second = -kFar;
    int leaf = -1, leaf_to = -1;
    for (int v = 0; v < n; ++v) {
      if (degree[v] != 1) continue;
      Sum least = kFar;
      int to = -1;
      for (const auto& leg : candidates_.of(v)) more_of[leg.to] = extra_[index(leg)];
      for (int w = 0; w < n; ++w) {
        if (w == v || from[v] == w || from[w] == v) continue;
        const Sum leg = priced(costs_.lower(v, w), v, w) + more_of[w];
        if (leg < least) least = leg, to = w;
      }
      for (const auto& leg : candidates_.of(v)) more_of[leg.to] = 0;
      if (least > second) second = least, leaf = v, leaf_to = to;
    }
    let_in(leaf, leaf_to, more);
    value += second;
    return value - told();
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
  std::vector<Cut> cuts_;
  // By leg, as the candidates have them: what cuts cost more, the same leg in the other direction,
  // and which cuts have it.
  std::vector<Sum> extra_;
  std::vector<std::size_t> back_, tree_;
  std::vector<std::vector<int>> of_leg_;
  std::vector<double> share_;  // times weight_: the mean of the trees, of the lower leg
  double weight_ = 1, shares_ = 0;
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
