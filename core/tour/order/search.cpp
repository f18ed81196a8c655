#include "core/tour/order/search.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/tour/order/local_search.h"
#include "core/tour/order/one_more.h"
#include "core/tour/order/recombine.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/order/window_search.h"

namespace lasius::tour {

namespace {

constexpr int kCandidates = 8;
// Few tours converge soon, many to better ones: each colony has twice as many as the one before.
constexpr int kFirstAnts = 10, kMostAnts = 40;
constexpr double kKicksOfAnt = 0.3;  // a stop
constexpr int kPatience = 3;         // generations without change
constexpr int kSoon = 5000;          // stops: by bounds alone in some tenths of a second

// The search over closed tours of more than kMostBySubsets stops.
class Colony {
 public:
  Colony(const Costs& costs, const Candidates& candidates, const OrderOptions& options,
         const std::function<bool(const ArrayTour&)>& found)
      : costs_(costs),
        candidates_(candidates),
        options_(options),
        found_(found),
        local_(costs, candidates),
        recombiner_(costs, candidates),
        poller_(options.stop, 1 << 12) {}

  /// From the tour `first`, which was told, or by savings where that is cheaper.
  void run(std::optional<ArrayTour> first) {
    const int n = costs_.size();
    const std::int64_t kicks = options_.kicks < 0 ? n : options_.kicks;
    best_.emplace(costs_, savings_order(costs_, candidates_));
    if (first) told_ = first->cost();
    if (first && told_ <= best_->cost()) best_ = std::move(first);
    kernels::RandomStream random(options_.seed, 0, 0, kUse);
    const bool done = local_.improve(*best_, poller_);
    if (!offer(*best_) || !done) return;
    if (!kick(*best_, kicks, random) || !offer(*best_)) return;
    if (n < 8) return;
    for (std::uint32_t colony = 1; begin(colony) && evolve(colony, kicks); ++colony) {
    }
  }
  StopCondition::Cause cause() const { return poller_.cause(); }

 private:
  static constexpr std::uint32_t kUse = 0x70757273;

  // In portions, so that what was found is told meanwhile.
  bool kick(ArrayTour& tour, std::int64_t times, kernels::RandomStream& random) {
    while (times > 0) {
      const std::int64_t portion = std::min<std::int64_t>(times, 256);
      if (!local_.kick(tour, portion, random, poller_)) {
        offer(tour);
        return false;
      }
      if (!offer(tour)) return false;
      times -= portion;
    }
    return true;
  }

  bool offer(const ArrayTour& tour) {
    if (told_ >= 0 && tour.cost() >= told_) return true;
    told_ = tour.cost();
    if (&tour != &*best_) best_ = tour;
    return found_(tour) && told_ > options_.target;
  }

  bool begin(std::uint32_t colony) {
    ants_.assign(1, *best_);
    const int ants = colony > 2 ? kMostAnts : kFirstAnts << (colony - 1);
    for (std::uint32_t i = 1; static_cast<int>(i) < ants; ++i) {
      if (generations_ == options_.generations) return false;
      kernels::RandomStream random(options_.seed, i, colony, kUse);
      ants_.emplace_back(costs_, random_order(costs_, candidates_, random));
      if (!local_.improve(ants_.back(), poller_)) return false;
      if (!kick(ants_.back(), static_cast<std::int64_t>(kKicksOfAnt * costs_.size()), random))
        return false;
    }
    return true;
  }

  bool evolve(std::uint32_t colony, std::int64_t kicks) {
    const int ants = static_cast<int>(ants_.size());
    kernels::RandomStream random(options_.seed, kMostAnts, colony, kUse);
    std::vector<int> cycle(ants_.size());
    for (int idle = 0; idle < kPatience; ++idle) {
      if (generations_++ == options_.generations) return false;
      std::iota(cycle.begin(), cycle.end(), 0);
      for (int i = ants; i > 1; --i) std::swap(cycle[i - 1], cycle[random.below(i)]);
      for (int i = 0; i < ants; ++i) {
        ArrayTour& ant = ants_[cycle[i]];
        if (recombiner_.improve(ant, ants_[cycle[(i + 1) % ants]], random, poller_)) {
          idle = -1;
          if (!offer(ant)) return false;
        }
        if (poller_.stop_after(costs_.size())) return false;
      }
    }
    ArrayTour tour = *best_;
    return kick(tour, kicks, random);
  }

  const Costs& costs_;
  const Candidates& candidates_;
  const OrderOptions& options_;
  const std::function<bool(const ArrayTour&)>& found_;
  LocalSearch local_;
  Recombiner recombiner_;
  Poller poller_;
  std::optional<ArrayTour> best_;
  std::vector<ArrayTour> ants_;
  std::int64_t told_ = -1;
  int generations_ = 0;
};

struct Bounds final : Pricer {
  explicit Bounds(const Costs& of) : costs(of) {}
  Cost price(int a, int b) override { return costs.lower(a, b); }
  Cost lower(int a, int b) const override { return costs.lower(a, b); }
  Cost largest() const override { return costs.largest(); }
  Costs costs;
};

// A round tour that is short by the bounds of costs: no leg is priced. Of few stops soon there, and
// the same whatever the time.
std::vector<int> round_by_bounds(const Costs& costs, std::span<const Point> places,
                                 std::span<const std::pair<int, int>> more,
                                 const StopCondition& stop) {
  Bounds bounds(costs);
  const Costs known(costs.size(), bounds, false);
  Candidates candidates(known, places, kCandidates, stop);
  if (!more.empty()) candidates.add(known, more);
  ArrayTour tour(known, savings_order(known, candidates));
  const StopCondition never;
  Poller poller(costs.size() <= kSoon ? never : stop, 1 << 12);
  LocalSearch(known, candidates).improve(tour, poller);
  return tour.order();
}

}  // namespace

void check_ends(int size, const Ends& ends) {
  for (const int end : {ends.start, ends.goal})
    if (end < -1 || end >= size)
      refuse("there is no stop " + number_text(end), "give one of the stops, from 0");
  if (ends.goal >= 0 && !ends.open) refuse("a closed tour has no goal", "ask for an open one");
  if (ends.goal >= 0 && ends.goal == ends.start && size > 1)
    refuse("start and goal are the same stop", "ask for a closed tour from there");
}

OrderFound find_order(const Costs& costs, const Ends& ends, std::span<const Point> places,
                      const OrderOptions& options) {
  check_ends(costs.size(), ends);
  OrderFound result;
  const PartialOrder any, &given = options.given != nullptr ? *options.given : any;
  const auto tell = [&] {
    return !options.observer || options.observer(result.order, result.cost);
  };
  if (costs.size() <= kMostBySubsets) {
    result.order = subset_order(costs, ends, given);
    result.cost = cost_of(costs, result.order, ends.open);
    result.optimal = true;
    if (!result.order.empty()) tell();
    return result;
  }
  if (!given.any_order()) return find_partial_order(costs, ends, given, options);
  const std::optional<OneMore> more =
      ends.open ? std::optional<OneMore>(std::in_place, costs, ends) : std::nullopt;
  const Costs& closed = more ? more->costs() : costs;
  const std::function<bool(const ArrayTour&)> found = [&](const ArrayTour& tour) {
    result.order = more ? more->opened(tour.order()) : tour.order();
    if (!ends.open && ends.start >= 0)
      std::rotate(result.order.begin(),
                  std::find(result.order.begin(), result.order.end(), ends.start),
                  result.order.end());
    result.cost = tour.cost() - (more ? more->surplus() : 0);
    return tell();
  };
  OrderOptions inner = options;
  if (more) inner.target += more->surplus();
  std::vector<std::pair<int, int>> legs_of_more;
  if (more) legs_of_more = more->all_legs();
  std::vector<int> round = options.first;
  if (more && !round.empty()) round.push_back(costs.size());
  if (round.empty() && closed.priced_late())
    round = round_by_bounds(closed, places, legs_of_more, options.stop);
  std::optional<ArrayTour> first;
  if (!round.empty()) {
    first.emplace(closed, std::move(round));
    result.cause = options.stop.poll();  // legs that were not priced tell nothing of other tours
    if (!found(*first) || result.cause != StopCondition::Cause::none ||
        first->cost() <= inner.target)
      return result;
  }
  Poller poller(options.stop);  // once it stops, what is first will do
  Candidates candidates(closed, places, kCandidates, poller, first ? 0 : Candidates::kMany);
  if (more) candidates.add(closed, legs_of_more);
  Colony colony(closed, candidates, inner, found);
  colony.run(std::move(first));
  result.cause = colony.cause();
  return result;
}

}  // namespace lasius::tour
