#include "core/tour/order/bound.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/tour/order/ascend.h"
#include "core/tour/order/combs.h"
#include "core/tour/order/one_more.h"
#include "core/tour/order/one_tree.h"

namespace lasius::tour {

namespace {

constexpr int kBoundCandidates = 6, kNearTree = 3;
constexpr int kMostTurns = 300;
// Subgradients' mean and patience of a climb; each step slower has twice as long ones. In corridors
// a bound is lost where steps become short too soon: where a wide gap is left slow ones follow.
constexpr ClimbPace kQuick{0.1, 10, 0.66};
constexpr int kSlow = 3, kSlowest = 4;
constexpr Sum kWide = 25;  // of the length
// Among clusters far apart climbs leave it, and plain ascent goes on from there: so many values of
// one stop without gain.
constexpr int kIdleStops = 100'000, kLeastIdle = 50, kMostIdle = 500;
// A round that closes less of the gap is a poor one, and the next ones are slower.
constexpr Sum kLeastGain = 30;
constexpr int kMostPoor = 4;
constexpr Sum kGapNotWorth = 100'000;                // of the length: a gap worth no round
constexpr double kNewShare = 0.01, kNoShare = 0.01;  // of a tree, in the mean of all; of a leg

class Ascent {
 public:
  Ascent(const Costs& costs, std::span<const Point> places, Poller& poller)
      : costs_(costs), trees_(costs, places, kBoundCandidates, poller), poller_(poller) {}

  OneTree& trees() { return trees_; }

  // The greatest valid bound, scaled; 0 if stopped before there was one. `length`: what of `upper`
  // gaps are shares of.
  Sum run(Sum upper, Sum length, int rounds) {
    Sum bound = 0;
    int poor = 0, slow = 0;
    int wide = 0;  // rounds that left a wide gap
    for (int round = 0; round < rounds && poor < kMostPoor && !poller_.stopped(); ++round) {
      const Sum earlier = bound;
      number_legs();
      keep();
      if (wide > 1)
        ascend_plainly(upper);
      else
        climb(*this, upper,
              {kQuick.newest / (1 << std::min(slow, kSlow)),
               kQuick.patience << std::min(slow, kSlowest), kQuick.fall});
      OneTree::Pairs more;
      bound = asserted(bound, round == 0 ? kNearTree : 0, more);
      const Sum gap = upper - bound;
      if (gap < kScale || gap <= length / kGapNotWorth) break;
      poor = gap / kLeastGain > bound - earlier ? poor + 1 : 0;
      slow += poor > 0;
      if (gap <= length / kWide) {
        wide = 0;
        separate();
      } else {
        slow = kSlow;
        if (++wide < 3) std::fill(trees_.price.begin(), trees_.price.end(), 0);
      }
      if (!more.empty()) trees_.add(more);
    }
    return bound;
  }

  // For climb() and ascend().
  Sum value() {
    const Sum tree = trees_.sparse();
    return poller_.stop_after(16 * static_cast<Sum>(costs_.size())) ? kFar : tree - told();
  }
  void keep() {
    best_ = trees_.price;
    for (Cut& cut : cuts_) cut.best = cut.price;
  }
  void back() {
    trees_.price = best_;
    for (Cut& cut : cuts_) set_price(cut, cut.best);
  }
  // Of stops, then of cuts.
  const std::vector<double>& subgradient() {
    count_legs();
    newest_.clear();
    for (const int degree : trees_.degree()) newest_.push_back(degree - 2);
    for (const Cut& cut : cuts_)
      newest_.push_back(static_cast<double>(cut.taken - cut.comb.most()));
    return newest_;
  }
  double squares() { return squares(subgradient()); }
  double squares(const std::vector<double>& mean) const {
    const std::size_t n = best_.size();
    double sum = 0;
    for (std::size_t i = 0; i < mean.size(); ++i)
      if (i < n || mean[i] > 0 || cuts_[i - n].best > 0) sum += mean[i] * mean[i];
    return sum;
  }
  void stand(double step, const std::vector<double>& mean) {
    const std::size_t n = best_.size();
    for (std::size_t v = 0; v < n; ++v)
      trees_.price[v] = best_[v] + static_cast<Sum>(step * mean[v]);
    for (std::size_t c = 0; c < cuts_.size(); ++c)
      set_price(cuts_[c], std::max<Sum>(0, cuts_[c].best + static_cast<Sum>(step * mean[n + c])));
  }

  // Along the newest subgradient, where there are no cuts yet.
  bool move(double step) {
    for (std::size_t v = 0; v < best_.size(); ++v)
      trees_.price[v] += static_cast<Sum>(step * newest_[v]);
    return true;
  }

 private:
  void ascend_plainly(Sum upper) {
    const double idle = std::clamp(kIdleStops / costs_.size(), kLeastIdle, kMostIdle);
    ascend(*this, upper, -kFar, {.first = 2, .last = 1e-3, .patience = idle});
    back();
  }

  // A comb with its price, which its legs cost more, those within handle and tooth twice.
  struct Cut {
    Comb comb;
    Sum price = 0, best = 0;
    std::vector<std::size_t> legs = {};  // candidates, both directions
    Sum taken = 0;                       // of the tree
  };

  // The value over all legs, which is a bound for every tour, and legs to let in. Where legs wind
  // and are priced late, prices belie bounds that are straight: the legs of the tree are priced
  // until it takes no others.
  Sum asserted(Sum bound, int near, OneTree::Pairs& more) {
    bound = std::max(bound, trees_.dense(more) - told());
    if (!costs_.priced_late()) trees_.near(near, poller_, more);
    for (int turn = 0; costs_.priced_late() && turn < kMostTurns && !more.empty(); ++turn) {
      for (const auto& [a, b] : more) costs_(a, b);
      if (poller_.stop_after(Poller::kWords)) break;
      const Sum before = bound;
      const auto known = std::exchange(more, {});
      bound = std::max(bound, trees_.dense(more) - told());
      if (bound == before && more == known) break;
    }
    return bound;
  }

  // Which legs are the same in the other direction, and which each cut has.
  void number_legs() {
    const int n = costs_.size();
    const Candidates& candidates = trees_.candidates();
    back_.assign(candidates.count(), 0);
    share_.assign(candidates.count(), 0);
    trees_.extra.assign(candidates.count(), 0);
    shares_ = 0;
    for (int v = 0; v < n; ++v)
      for (const auto& leg : candidates.of(v))
        for (const auto& other : candidates.of(leg.to))
          if (other.to == v) back_[trees_.index(leg)] = trees_.index(other);
    of_leg_.assign(candidates.count(), {});
    std::vector<char> in(n, 0);
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      Cut& cut = cuts_[c];
      cut.legs.clear();
      const auto list = [&](const std::vector<int>& set) {
        for (const int v : set) in[v] = 1;
        for (const int v : set)
          for (const auto& leg : candidates.of(v))
            if (in[leg.to]) cut.legs.push_back(trees_.index(leg));
        for (const int v : set) in[v] = 0;
      };
      list(cut.comb.handle);
      for (const std::vector<int>& tooth : cut.comb.teeth) list(tooth);
      for (const std::size_t leg : cut.legs) {
        of_leg_[leg].push_back(static_cast<int>(c));
        trees_.extra[leg] += cut.price;
      }
    }
  }

  void set_price(Cut& cut, Sum price) {
    for (const std::size_t leg : cut.legs) trees_.extra[leg] += price - cut.price;
    cut.price = price;
  }

  // What the tree takes: of each cut, and of each leg on average.
  void count_legs() {
    shares_ = shares_ * (1 - kNewShare) + kNewShare;
    weight_ /= 1 - kNewShare;
    for (Cut& cut : cuts_) cut.taken = 0;
    for (const std::size_t leg : trees_.tree()) {
      share_[std::min(leg, back_[leg])] += weight_;
      for (const int c : of_leg_[leg]) ++cuts_[c].taken;
    }
    if (weight_ < 1e100) return;
    for (double& share : share_) share /= weight_;
    weight_ = 1;
  }

  // Drops cuts that cost nothing, and finds others.
  void separate() {
    std::erase_if(cuts_, [](const Cut& cut) { return cut.price == 0; });
    std::vector<SharedLeg> legs;
    for (int v = 0; v < costs_.size(); ++v)
      for (const auto& leg : trees_.candidates().of(v)) {
        const double share = share_[trees_.index(leg)] * kNewShare / weight_ / shares_;
        if (share > kNoShare) legs.push_back({v, leg.to, share});
      }
    for (Comb& comb : combs_of(costs_.size(), legs, poller_))
      if (std::none_of(cuts_.begin(), cuts_.end(),
                       [&](const Cut& cut) { return cut.comb == comb; }))
        cuts_.push_back({std::move(comb)});
  }

  // What all prices are worth to a tour.
  Sum told() const {
    Sum sum = 0;
    for (const Sum price : trees_.price) sum += 2 * price;
    for (const Cut& cut : cuts_) sum += cut.price * cut.comb.most();
    return sum;
  }

  const Costs& costs_;
  OneTree trees_;
  Poller& poller_;
  std::vector<Sum> best_;  // prices of stops
  std::vector<Cut> cuts_;
  std::vector<double> newest_;
  // By leg, as the candidates have them: the same leg in the other direction, and which cuts have
  // it.
  std::vector<std::size_t> back_;
  std::vector<std::vector<int>> of_leg_;
  std::vector<double> share_;  // times weight_: the mean of the trees, of the lower leg
  double weight_ = 1, shares_ = 0;
};

}  // namespace

std::int64_t tour_bound(const Costs& costs, const Ends& ends, std::span<const Point> places,
                        std::int64_t upper, int rounds, Poller& poller, std::int64_t alike) {
  if (costs.size() < 2) return 0;
  if (costs.size() == 2) return std::int64_t{costs.lower(0, 1)} * (ends.open ? 1 : 2);
  const std::optional<OneMore> more =
      ends.open ? std::optional<OneMore>(std::in_place, costs, ends) : std::nullopt;
  const std::int64_t surplus = more ? more->surplus() : 0;
  Ascent ascent(more ? more->costs() : costs, places, poller);
  if (more) ascent.trees().add(more->all_legs());
  const Sum bound = ascent.run((upper + surplus) * kScale, (upper - alike) * kScale, rounds);
  if (bound <= surplus * kScale) return 0;
  return std::min(upper, (bound + kScale - 1) / kScale - surplus);
}

}  // namespace lasius::tour
