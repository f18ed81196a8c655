// Tours whose legs are cheapest paths over costs.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/grid/distance.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/search.h"
#include "core/tour/route_tour.h"
#include "core/tour/routes/find_routes.h"

namespace lasius {

namespace {

using tour::Cost;
using tour::Costs;

constexpr int kMostOverCosts = 200;   // stops, whose pairs are all priced
constexpr double kGapOfLegs = 0.002;  // unless the tour's target is larger
constexpr double kShareOfLegs = 0.7;  // of the time to a deadline
constexpr double kAnyGap = 1e9;       // a leg's, where the time is up

struct Leg {
  bool known = false;  // not cut short
  double cost = 0, lower = 0, length = 0;
  std::vector<Point> path = {};  // from the lower stop
};

using Routes = std::vector<std::vector<int>>;

// Short by straight ways, at once; by places. None where none was found.
Routes routes_by_straight_ways(const TourStops& stops, const TourRequest& request) {
  std::vector<Cost> matrix;
  matrix.reserve(stops.places.size() * stops.places.size());
  for (const Point a : stops.places)
    for (const Point b : stops.places) matrix.push_back(tour::grains(distance(a, b)));
  const Costs costs(stops.size(), matrix.data());
  if (is_routed(request))
    return find_routes(stops.routes, costs, {.seed = request.seed, .generations = 0}).orders;
  tour::OrderFound found =
      find_order(costs, stops.ends, stops.places,
                 {.seed = request.seed, .generations = 0, .given = &stops.given});
  return found.order.empty() ? Routes{} : Routes{std::move(found.order)};
}

class LegsOverCosts {
 public:
  /// Prices the legs of `first` first, then those between near stops.
  LegsOverCosts(const CostPlanner& planner, const TourStops& stops, const TourRequest& request,
                const Routes& first)
      : planner_(planner), places_(stops.places), n_(stops.size()) {
    options_.params = Params("exact");
    gap_ = std::max(kGapOfLegs, request.target_gap / 2);
    legs_.resize(static_cast<std::size_t>(n_) * n_);
    const StopCondition stop = earlier(request.stop, kShareOfLegs);
    std::vector<int> task_of(n_, -1);
    for (int task = 0; task < stops.routes.size(); ++task)
      for (const int stop_of : stops.routes.tasks[task]) task_of[stop_of] = task;
    std::vector<std::pair<int, int>> pairs;
    for (int a = 0; a < n_; ++a)
      for (int b = a + 1; b < n_; ++b)
        if (task_of[a] < 0 || task_of[a] != task_of[b]) pairs.emplace_back(a, b);
    sort(pairs, tour::legs_of(first, request.open));
    std::atomic<int> priced{0};
    std::atomic<bool> cut{false};
    parallel_for(static_cast<int>(pairs.size()), thread_count(request.threads), [&](int i, int) {
      if (stop.poll() != StopCondition::Cause::none) {
        cut = true;
        return;
      }
      plan(pairs[i].first, pairs[i].second, gap_, stop);
      if (legs_[index(pairs[i].first, pairs[i].second)].known) ++priced;
    });
    priced_ = priced;
    cut_ = cut || stop.poll() != StopCondition::Cause::none;
    double most = 1;
    for (const Leg& leg : legs_) most = std::max(most, leg.cost);
    for (int a = 0; a < n_; ++a)
      for (int b = a + 1; b < n_; ++b) most = std::max(most, least(a, b));
    scale_ = std::min(tour::kGrains, 0.5 * tour::kLargest / most);
    matrix_.assign(legs_.size(), 0);
    lower_ = matrix_;
    for (int a = 0; a < n_; ++a)
      for (int b = a + 1; b < n_; ++b) set_costs(a, b);
  }

  Costs costs() const { return {n_, matrix_.data()}; }
  Costs lower() const { return {n_, lower_.data()}; }
  double scale() const noexcept { return scale_; }
  int priced() const noexcept { return priced_; }
  /// Whether the time was up before all legs were priced.
  bool cut() const noexcept { return cut_; }

  /// Plans those that are not known, some path each, whatever stops the search.
  void complete(std::span<const std::pair<int, int>> legs, int threads) {
    std::vector<std::pair<int, int>> missing;
    for (const auto& [a, b] : legs)
      if (!leg(a, b).known) missing.emplace_back(std::min(a, b), std::max(a, b));
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    parallel_for(static_cast<int>(missing.size()), thread_count(threads),
                 [&](int i, int) { plan(missing[i].first, missing[i].second, kAnyGap, {}); });
    for (const auto& [a, b] : missing) set_costs(a, b);
  }
  /// From the lower stop to the higher.
  const Leg& leg(int a, int b) const { return legs_[index(std::min(a, b), std::max(a, b))]; }

 private:
  void sort(std::vector<std::pair<int, int>>& pairs,
            const std::vector<std::pair<int, int>>& first) const {
    std::vector<double> when(legs_.size());
    for (const auto& [a, b] : pairs) when[index(a, b)] = apart(a, b);
    for (const auto& [a, b] : first) when[index(std::min(a, b), std::max(a, b))] = -1;
    std::stable_sort(pairs.begin(), pairs.end(), [&](const auto& p, const auto& q) {
      return when[index(p.first, p.second)] < when[index(q.first, q.second)];
    });
  }
  void set_costs(int a, int b) {
    const Leg& leg = legs_[index(a, b)];
    // Those that are not priced are dear, the longer the dearer.
    const Cost cost =
        leg.known ? tour::grains(leg.cost, scale_) : tour::kLargest / 2 + tour::grains(apart(a, b));
    matrix_[index(a, b)] = matrix_[index(b, a)] = cost;
    lower_[index(a, b)] = lower_[index(b, a)] =
        tour::grains(std::max(leg.lower, least(a, b)), scale_);
  }
  double apart(int a, int b) const { return distance(places_[a], places_[b]); }
  /// What the straight way costs at the least weight.
  double least(int a, int b) const { return planner_.least_weight() * apart(a, b); }

  std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * n_ + b; }
  void plan(int a, int b, double gap, const StopCondition& stop) {
    CostResult found = planner_.plan(
        {.stop = stop, .target_gap = gap, .start_point = places_[a], .goal_point = places_[b]},
        options_);
    if (found.path.empty() || !std::isfinite(found.cost)) return;
    Leg& leg = legs_[index(a, b)];
    leg.lower = std::max(leg.lower, found.optimal ? found.cost : found.lower_bound.value_or(0));
    leg.known = found.status == Status::solved;
    if (leg.path.empty() || found.cost < leg.cost)
      leg = {leg.known, found.cost, leg.lower, found.length, std::move(found.path)};
  }

  const CostPlanner& planner_;
  std::span<const Point> places_;
  int n_, priced_ = 0;
  bool cut_ = false;
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
    refuse(number_text(n) + " stops are too many for a tour over costs",
           "give at most " + number_text(kMostOverCosts) + ", or plan by length");
  if (request.stop.token.stop_requested()) {
    tour.status = Status::interrupted;
    return tour;
  }
  const Routes first = by_ants(request) ? Routes{} : routes_by_straight_ways(stops, request);
  LegsOverCosts legs(planner, stops, request, first);
  tour.priced = legs.priced();
  const Costs costs = legs.costs(), lower = legs.lower();
  Orders found = orders_and_bound(costs, lower, stops, request, legs.scale(), observer, tour);
  if (found.orders.empty()) return tour;
  const auto known = [&](const auto& ends) { return legs.leg(ends.first, ends.second).known; };
  if (legs.cut() && !std::ranges::all_of(tour::legs_of(first, request.open), known))
    found.orders = first;  // few known legs among dear ones lead the search astray
  legs.complete(tour::legs_of(found.orders, request.open), request.threads);
  if (legs.cut() && !first.empty() &&
      cost_of(costs, first, request.open) < cost_of(costs, found.orders, request.open))
    found.orders = first;
  tour.status = status_after(found.cause, request.stop);
  if (tour.status == Status::solved && legs.cut()) tour.status = Status::limit;
  set_orders(request, stops, found, tour);
  std::vector<std::pair<int, int>> places;
  for (const TourLeg& leg : tour.legs)
    places.emplace_back(stops.place_of(leg.from), stops.place_of(leg.to));
  for (std::size_t i = 0; i < places.size(); ++i) {
    TourLeg& told = tour.legs[i];
    const auto& [a, b] = places[i];
    const Leg& leg = legs.leg(a, b);
    if (!leg.known) {
      TourResult none;
      none.status = Status::no_path;
      none.error = "no path was found from stop " + number_text(told.from) + " to stop " +
                   number_text(told.to);
      none.left_out = std::move(tour.left_out);
      return none;
    }
    told = {told.from, told.to, leg.length, leg.path, leg.cost};
    if (a > b) std::reverse(told.path.begin(), told.path.end());
  }
  tour.cost = 0;
  sum_up(tour);
  if (found.bound > 0 || *tour.cost == 0)
    tour.lower_bound = std::min(*tour.cost, static_cast<double>(found.bound) / legs.scale());
  settle_optimal(tour);
  return tour;
}

}  // namespace lasius
