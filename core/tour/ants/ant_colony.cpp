#include "core/tour/ants/ant_colony.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/loop/colony_loop.h"
#include "core/loop/trail_rules.h"
#include "core/tour/ants/ant_trail.h"
#include "core/tour/ants/improver.h"
#include "core/tour/order/window_search.h"
#include "kernels/base/proportional.h"
#include "kernels/base/random_stream.h"

namespace lasius::tour {
namespace {

constexpr double kNearBest = 1.2;  // of the best tour's length, below which others are improved

/// What the rules of a trail ask of a tour, and of all tours of an iteration.
struct AntTour {
  std::span<const int> order;
  double length = kNaN;
};
struct AntTours {
  std::vector<AntTour> ants;
  AntTour best_so_far;
  bool open = false;
  int iteration = 0;
  mutable std::vector<int> ranking = {};

  double choices() const { return static_cast<double>(best_so_far.order.size()); }
  std::size_t moves_of(const AntTour& tour) const { return tour.order.size() - open; }
  template <class Visit>
  void along(const AntTour& tour, const Visit& visit) const {
    for (std::size_t i = 1; i < tour.order.size(); ++i)
      visit(Arc{tour.order[i - 1], tour.order[i]});
    if (!open) visit(Arc{tour.order.back(), tour.order.front()});
  }
};

/// The tour that goes to the nearest stop, from the first.
std::vector<int> nearest_order(const Costs& costs, int first) {
  std::vector<int> order{first}, left;
  for (int v = 0; v < costs.size(); ++v)
    if (v != first) left.push_back(v);
  while (!left.empty()) {
    std::size_t best = 0;
    const auto cost = [&](std::size_t i) {
      const Cost c = costs(order.back(), left[i]);
      return c < 0 ? kLargest : c;
    };
    for (std::size_t i = 1; i < left.size(); ++i)
      if (cost(i) < cost(best)) best = i;
    order.push_back(left[best]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return order;
}

// Pieces are exchanged behind a start, which closed tours have then.
Ends ends_for(const AntParams& params, const Ends& ends, const std::vector<int>& first) {
  Ends kept = ends;
  if (params.local_search == Improvement::pieces && !ends.open && ends.start < 0)
    kept.start = first.front();
  return kept;
}

std::vector<double> visibility_of(const Costs& costs, double beta) {
  const int n = costs.size();
  std::vector<double> eta;
  eta.reserve(static_cast<std::size_t>(n) * n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const Cost cost = costs(a, b);  // below 0 where b comes before a
      eta.push_back(a == b || cost < 0 ? 0 : kernels::power(1.0 / std::max(cost, 1), beta));
    }
  return eta;
}

class AntColony final : public ColonyWorld {
 public:
  AntColony(const Costs& costs, const Ends& ends, bool symmetric, const AntParams& params,
            int threads, const OrderOptions& options, const PartialOrder& given, OrderFound& found)
      : costs_(costs),
        params_(params),
        threads_(threads),
        options_(options),
        given_(given),
        found_(found),
        n_(costs.size()),
        ants_(params.ants > 0 ? params.ants : n_),
        stepwise_(find_algorithm(params.algorithm()).has("local_evaporation")),
        greedy_(params.drawn > 0 ? std::max(0.0, 1 - params.drawn / n_) : params.greedy),
        first_(first_tour(ends)),
        ends_(ends_for(params, ends, first_)),
        rules_(params),
        tau0_(first_tau()),
        trail_(n_, tau0_, params.alpha, symmetric && given.any_order(),
               visibility_of(costs, params.beta)),
        improver_(costs, ends_, given, params.local_search, symmetric, this->threads(),
                  options.stop),
        walkers_(static_cast<std::size_t>(ants_)) {
    if (params.elite_weight == 0) rules_.elite_weight = n_;
    if (params.candidates > 0) nearest_.emplace(costs, std::span<const Point>(), params.candidates);
    tours_.ants.resize(walkers_.size());
    tours_.open = ends.open;
  }

  StopCondition::Cause send_ants(int q) override {
    trail_.refresh();
    Poller poller(options_.stop);
    for (int a = 0; a < ants_; ++a) begin(walkers_[a], a, q);
    if (stepwise_) {  // one step each, which the others then see
      std::vector<double> room;
      for (int step = 1; step < n_; ++step)
        for (Walker& walker : walkers_) {
          go_on(walker, room);
          if (poller.stop_after(n_)) return lose_all(poller.cause());
        }
      for (const Walker& walker : walkers_)
        if (!ends_.open && arrived(walker)) pass({walker.order.back(), walker.order.front()});
    }
    const int threads = this->threads();
    std::vector<std::vector<double>> rooms(static_cast<std::size_t>(threads));
    std::vector<StopCondition::Cause> causes(walkers_.size(), StopCondition::Cause::none);
    parallel_for(ants_, threads, [&](int a, int thread) {
      Walker& walker = walkers_[a];
      Poller own(options_.stop);
      while (!stepwise_ && static_cast<int>(walker.order.size()) < n_)
        if (own.stop_after(n_) || !go_on(walker, rooms[thread])) break;
      if (!own.stopped() && arrived(walker) && is_to_improve(walker))
        walker.order = improver_.improved(
            std::move(walker.order),
            as_best() ? std::span<const int>(best_) : std::span<const int>(), thread, own);
      causes[a] = own.cause();
    });
    tours_.iteration = q;
    for (int a = 0; a < ants_; ++a) {
      const Walker& walker = walkers_[a];
      const bool whole = arrived(walker) && causes[a] == StopCondition::Cause::none;
      tours_.ants[a] = {walker.order, whole ? measured(walker.order) : kNaN};
    }
    const auto cut = std::ranges::find_if(
        causes, [](StopCondition::Cause cause) { return cause != StopCondition::Cause::none; });
    return cut == causes.end() ? StopCondition::Cause::none : *cut;
  }

  void offer() override {
    const AntTour* best = nullptr;
    for (const AntTour& tour : tours_.ants)
      if (trail_rules::arrived(tour) && (best == nullptr || tour.length < best->length))
        best = &tour;
    iteration_best_ = best != nullptr ? best->length : kNaN;
    if (best == nullptr ||
        (trail_rules::arrived(tours_.best_so_far) && !(best->length < tours_.best_so_far.length)))
      return;
    best_.assign(best->order.begin(), best->order.end());
    tours_.best_so_far = {best_, best->length};
    behind_.assign(static_cast<std::size_t>(n_), -1);
    tours_.along(tours_.best_so_far, [&](const Arc& arc) { behind_[arc.from] = arc.to; });
    found_.order = best_;
    if (!ends_.open && ends_.start >= 0)
      std::rotate(found_.order.begin(), std::ranges::find(found_.order, ends_.start),
                  found_.order.end());
    found_.cost = cost_of(costs_, best_, ends_.open);
    if (options_.observer && !options_.observer(found_.order, found_.cost)) enough_ = true;
    if (found_.cost <= options_.target) enough_ = true;
  }

  void update_trail(int) override {
    using namespace trail_rules;
    const std::string& name = params_.algorithm();
    if (name == "as") ant_system(trail_, rules_, tours_);
    if (name == "eas") elitist(trail_, rules_, tours_, tours_.best_so_far);
    if (name == "ras") rank(trail_, rules_, tours_);
    if (name == "mmas") max_min(trail_, rules_, tours_);
    if (stepwise_) colony_system(trail_, rules_, tours_, tours_.best_so_far);
  }

  int ants() const override { return ants_; }
  int threads() const override {
    return costs_.priced_late() ? 1 : std::min(ants_, thread_count(threads_));
  }
  double tour_length(int ant) const override { return tours_.ants[ant].length; }
  double best_length() const override { return tours_.best_so_far.length; }
  double iteration_best() const override { return iteration_best_; }
  bool settled() override { return enough_; }
  StopCondition::Cause observe(const Convergence&) override { return StopCondition::Cause::none; }

 private:
  struct Walker {
    kernels::RandomStream random{0, 0, 0};
    std::vector<int> order = {};
    std::vector<char> closed = {};  // visited, or the goal, which has its turn at last
    std::vector<int> left = {};     // rising; those that are closed since go at the next look
    std::vector<int> missing = {};  // of what comes before each stop; empty where nothing is given
    std::int64_t carried = 0;
  };

  // The nearest that may follow, where that is known to come to all stops.
  std::vector<int> first_tour(const Ends& ends) const {
    std::vector<int> order;
    if (!given_.any_order()) order = first_order(costs_, ends, given_).order;
    return order.empty() ? nearest_order(costs_, std::max(ends.start, 0)) : order;
  }
  double first_tau() const {
    if (params_.initial_pheromone > 0) return params_.initial_pheromone;
    const double cost = measured(first_);
    const double lost = std::max(1 - params_.persistence, 1e-9), m = ants_, w = params_.ranks;
    const std::string& name = params_.algorithm();
    const double e = params_.elite_weight > 0 ? params_.elite_weight : n_;
    return params_.deposit / cost *
           (name == "as"     ? m
            : name == "eas"  ? (m + e) / lost
            : name == "ras"  ? 0.5 * w * (w - 1) / lost
            : name == "mmas" ? 1 / lost
                             : 1.0 / n_);
  }
  bool arrived(const Walker& walker) const { return static_cast<int>(walker.order.size()) == n_; }
  double measured(const std::vector<int>& order) const {
    return static_cast<double>(std::max<std::int64_t>(1, cost_of(costs_, order, ends_.open)));
  }
  /// Of a stop that is not visited.
  bool allowed(const Walker& walker, int stop) const {
    return (walker.missing.empty() || walker.missing[stop] == 0) &&
           (!given_.limited() || walker.carried + given_.load(stop) <= given_.capacity());
  }
  StopCondition::Cause lose_all(StopCondition::Cause cause) {
    for (AntTour& tour : tours_.ants) tour.length = kNaN;
    return cause;
  }

  void begin(Walker& walker, int ant, int q) {
    constexpr std::uint32_t kUse = 0x73746e61;
    walker.random = {options_.seed, static_cast<std::uint32_t>(ant), static_cast<std::uint32_t>(q),
                     kUse};
    walker.order.clear();
    walker.closed.assign(static_cast<std::size_t>(n_), 0);
    walker.left.resize(static_cast<std::size_t>(n_));
    std::iota(walker.left.begin(), walker.left.end(), 0);
    walker.carried = 0;
    if (given_.has_relation()) {
      walker.missing.resize(static_cast<std::size_t>(n_));
      for (int v = 0; v < n_; ++v) walker.missing[v] = static_cast<int>(given_.previous(v).size());
    }
    if (ends_.goal >= 0 && n_ > 1) walker.closed[ends_.goal] = 1;
    // A closed tour may begin anywhere, unless an order is given.
    if (ends_.start >= 0 && (ends_.open || !given_.any_order() || improver_.keeps_start())) {
      if (allowed(walker, ends_.start)) visit(walker, ends_.start);
      return;
    }
    std::vector<int> firsts;
    for (int v = 0; v < n_; ++v)
      if (walker.closed[v] == 0 && allowed(walker, v)) firsts.push_back(v);
    if (!firsts.empty())
      visit(walker, firsts[walker.random.below(static_cast<int>(firsts.size()))]);
  }
  void visit(Walker& walker, int stop) {
    walker.order.push_back(stop);
    walker.closed[stop] = 1;
    walker.carried += given_.load(stop);
    if (!walker.missing.empty())
      for (const int next : given_.next(stop)) --walker.missing[next];
  }
  /// One step; false where there is none.
  bool go_on(Walker& walker, std::vector<double>& room) {
    if (walker.order.empty()) return false;
    const bool last = static_cast<int>(walker.order.size()) == n_ - 1;
    const int from = walker.order.back();
    const int to = last && ends_.goal >= 0 ? (allowed(walker, ends_.goal) ? ends_.goal : -1)
                                           : chosen(walker, from, room);
    if (to < 0) return false;
    visit(walker, to);
    if (stepwise_) pass({from, to});
    return true;
  }
  void pass(const Arc& arc) { trail_rules::pass(trail_, rules_, tau0_, arc); }

  bool as_best() const {
    return params_.greedy_step == GreedyStep::as_best && trail_rules::arrived(tours_.best_so_far);
  }
  bool is_to_improve(const Walker& walker) const {
    return improver_.improves() &&
           (!as_best() || measured(walker.order) < kNearBest * tours_.best_so_far.length);
  }

  int chosen(Walker& walker, int from, std::vector<double>& room) const {
    const std::span<const double> weights = trail_.weights(from);
    const std::uint32_t word = walker.random.next();
    if (as_best() && word * 0x1p-32 < greedy_) {
      const int next = behind_[from];
      if (next >= 0 && walker.closed[next] == 0 && allowed(walker, next)) return next;
    }
    room.clear();
    if (nearest_) {
      const auto near = nearest_->of(from);
      for (const auto& leg : near)
        room.push_back(walker.closed[leg.to] == 0 && allowed(walker, leg.to) ? weights[leg.to] : 0);
      const int k = kernels::proportional_choice(room, greedy_, word);
      if (k >= 0) return near[k].to;
      room.clear();
    }
    std::erase_if(walker.left, [&](int v) { return walker.closed[v] != 0; });
    const bool all = walker.missing.empty() && !given_.limited();
    room.resize(walker.left.size());
    for (std::size_t i = 0; i < room.size(); ++i) {
      const int v = walker.left[i];
      room[i] = all || allowed(walker, v) ? weights[v] : 0;
    }
    const int k = kernels::proportional_choice(room, nearest_ ? 1 : greedy_, word);
    if (k >= 0) return walker.left[k];
    for (const int v : walker.left)  // all weights have underflowed
      if (allowed(walker, v)) return v;
    return -1;
  }

  const Costs& costs_;
  const AntParams& params_;
  const int threads_;
  const OrderOptions& options_;
  const PartialOrder& given_;
  OrderFound& found_;
  const int n_, ants_;
  const bool stepwise_;  // each ant sees what those before it left
  const double greedy_;
  const std::vector<int> first_;
  const Ends ends_;
  TrailParams rules_;
  double tau0_;
  AntTrail trail_;
  Improver improver_;
  std::vector<Walker> walkers_;
  AntTours tours_;
  std::vector<int> best_, behind_;  // the best tour, and behind each stop the next in it, or -1
  std::optional<Candidates> nearest_;
  double iteration_best_ = kNaN;
  bool enough_ = false;
};

}  // namespace

OrderFound find_order_by_ants(const Costs& costs, const Ends& ends, bool symmetric,
                              const AntParams& params, int threads, const OrderOptions& options,
                              Convergence& run) {
  check_ends(costs.size(), ends);
  if (costs.size() > kMostForAnts)
    refuse(number_text(costs.size()) + " stops are too many for " + params.algorithm(),
           "give at most " + number_text(kMostForAnts) + ", or ask exact");
  constexpr int kMostChoices = 100'000'000;  // 9 to 13 bytes each
  if (params.ants > kMostChoices / costs.size())
    refuse(
        number_text(params.ants) + " ants are too many for " + number_text(costs.size()) + " stops",
        "give at most " + number_text(kMostChoices / costs.size()));
  OrderFound found;
  const PartialOrder any, &given = options.given != nullptr ? *options.given : any;
  AntColony colony(costs, ends, symmetric, params, threads, options, given, found);
  found.cause = run_colony_loop(colony, params.iterations, options.stop, run);
  return found;
}

}  // namespace lasius::tour
