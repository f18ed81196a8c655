// Tours whose legs are cheapest paths over costs.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/tour/map_pricer.h"
#include "core/tour/tour_steps.h"
#include "lasius/error.h"

namespace lasius {

namespace {

using tour::Cost;
using tour::Costs;

constexpr int kMostOverCosts = 200;   // stops, whose pairs are all priced
constexpr double kGapOfLegs = 0.002;  // unless the tour's target is larger
constexpr double kShareOfLegs = 0.7;  // of the time to a deadline

struct Leg {
  bool known = false;
  double cost = 0, lower = 0, length = 0;
  std::vector<Point> path = {};  // from the lower stop
};

class LegsOverCosts {
 public:
  LegsOverCosts(const CostPlanner& planner, std::span<const Point> places,
                const TourRequest& request)
      : planner_(planner), places_(places), n_(static_cast<int>(places.size())) {
    options_.params = Params("exact");
    gap_ = std::max(kGapOfLegs, request.target_gap / 2);
    legs_.resize(static_cast<std::size_t>(n_) * n_);
    StopCondition stop = request.stop;
    if (stop.deadline != Clock::time_point::max()) {
      const auto now = stop.now();
      stop.deadline =
          deadline_in(kShareOfLegs * std::chrono::duration<double>(stop.deadline - now), now);
    }
    std::vector<std::pair<int, int>> pairs;
    for (int a = 0; a < n_; ++a)
      for (int b = a + 1; b < n_; ++b) pairs.emplace_back(a, b);
    std::atomic<int> priced{0};
    parallel_for(static_cast<int>(pairs.size()), thread_count(request.threads), [&](int i, int) {
      if (stop.poll() != StopCondition::Cause::none) return;
      plan(pairs[i].first, pairs[i].second, stop);
      if (legs_[index(pairs[i].first, pairs[i].second)].known) ++priced;
    });
    priced_ = priced;
    double most = 1;
    for (const Leg& leg : legs_) most = std::max(most, leg.cost);
    scale_ = std::min(tour::kGrains, 0.5 * tour::kLargest / most);
    matrix_.assign(legs_.size(), 0);
    lower_ = matrix_;
    for (const auto& [a, b] : pairs) {
      const Leg& leg = legs_[index(a, b)];
      // Those that are not priced are dear, the longer the dearer.
      const double apart = std::sqrt((places_[a].x - places_[b].x) * (places_[a].x - places_[b].x) +
                                     (places_[a].y - places_[b].y) * (places_[a].y - places_[b].y));
      const Cost cost = leg.known ? grains(leg.cost) : tour::kLargest / 2 + tour::grains(apart);
      matrix_[index(a, b)] = matrix_[index(b, a)] = cost;
      lower_[index(a, b)] = lower_[index(b, a)] = leg.known ? grains(leg.lower) : 0;
    }
  }

  Costs costs() const { return {n_, matrix_.data()}; }
  Costs lower() const { return {n_, lower_.data()}; }
  double scale() const noexcept { return scale_; }
  int priced() const noexcept { return priced_; }

  /// Planned, whatever stops the search.
  const Leg& leg(int a, int b) {
    const int from = std::min(a, b), to = std::max(a, b);
    if (!legs_[index(from, to)].known) plan(from, to, {});
    return legs_[index(from, to)];
  }

 private:
  std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * n_ + b; }
  /// Rounded down, by what costs may be off too.
  Cost grains(double cost) const {
    return static_cast<Cost>(std::floor(cost * (1 - 1e-9) * scale_));
  }
  void plan(int a, int b, const StopCondition& stop) {
    CostResult found = planner_.plan(
        {.stop = stop, .target_gap = gap_, .start_point = places_[a], .goal_point = places_[b]},
        options_);
    if (found.path.empty() || !std::isfinite(found.cost)) return;
    legs_[index(a, b)] = {true, found.cost,
                          found.optimal ? found.cost : found.lower_bound.value_or(0), found.length,
                          std::move(found.path)};
  }

  const CostPlanner& planner_;
  std::span<const Point> places_;
  int n_, priced_ = 0;
  CostOptions options_;
  double gap_ = 0, scale_ = 1;
  std::vector<Leg> legs_;
  std::vector<Cost> matrix_, lower_;
};

}  // namespace

TourResult plan_tour(const CostPlanner& planner, const TourRequest& request,
                     const TourObserver& observer) {
  TourResult tour;
  const TourStops stops = stops_of(planner.planner(), request, tour);
  const int n = stops.size();
  if (n == 0) return tour;
  if (n > kMostOverCosts)
    throw Error(ErrorCode::invalid_parameter,
                number_text(n) + " stops are too many for a tour over costs",
                "give at most " + number_text(kMostOverCosts) + ", or plan by length");
  if (request.stop.token.stop_requested()) {
    tour.status = Status::interrupted;
    return tour;
  }
  LegsOverCosts legs(planner, stops.places, request);
  tour.priced = legs.priced();
  const Costs costs = legs.costs(), lower = legs.lower();
  const auto [found, bound] = order_and_bound(costs, lower, stops.ends, stops.places, stops.given,
                                              request, legs.scale(), observer, stops.indices, tour);
  if (found.order.empty()) {
    tell_no_order(stops.given, stops.ends, found, stops.indices, by_ants(request), tour);
    return tour;
  }
  tour.status = status_after(found.cause, request.stop);
  if (tour.status == Status::solved && legs.priced() < n * (n - 1) / 2)
    tour.status = Status::limit;  // which cut the legs' pricing short
  for (const int v : found.order) tour.order.push_back(stops.indices[v]);
  tour.cost = 0;
  const int count = n == 1 ? 0 : request.open ? n - 1 : n;
  for (int i = 0; i < count; ++i) {
    const int a = found.order[i], b = found.order[(i + 1) % n];
    const Leg& leg = legs.leg(a, b);
    tour.legs.push_back({stops.indices[a], stops.indices[b], leg.length, leg.path, leg.cost});
    if (a > b) std::ranges::reverse(tour.legs.back().path);
    tour.length += leg.length;
    *tour.cost += leg.cost;
  }
  if (bound > 0 || *tour.cost == 0)
    tour.lower_bound = std::min(*tour.cost, static_cast<double>(bound) / legs.scale());
  tour.optimal = tour.gap() && *tour.gap() <= 1e-9 && tour.status == Status::solved;
  return tour;
}

}  // namespace lasius
