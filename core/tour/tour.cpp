#include "lasius/tour/tour.h"

#include <algorithm>
#include <numeric>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/tour/ants/ant_colony.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/route_tour.h"
#include "core/tour/routes/exact_routes.h"
#include "lasius/path/path.h"

namespace lasius {

namespace {

using tour::Before;
using tour::Cost;
using tour::Costs;
using tour::PartialOrder;

constexpr int kRoutedAtOnce = 500;  // of groups and robots, whose search and bound ask for most
constexpr int kMostInWorld = 2000;  // stops, whose pairs are all priced

// All lengths, as they are and as costs.
class Priced {
 public:
  Priced() = default;
  Priced(std::vector<double> lengths, double scale) : scale_(scale), lengths_(std::move(lengths)) {
    matrix_.reserve(lengths_.size());
    for (const double length : lengths_) matrix_.push_back(tour::grains(length, scale));
  }
  bool empty() const noexcept { return matrix_.empty(); }
  Costs costs(int n) const { return {n, matrix_.data()}; }
  const std::vector<double>& lengths() const noexcept { return lengths_; }
  double scale() const noexcept { return scale_; }

 private:
  double scale_ = tour::kGrains;
  std::vector<double> lengths_;
  std::vector<Cost> matrix_;
};

// The order, its legs' ends, and the bound, but where it is the tour's own length: then true.
bool order_stops(const TourStops& stops, const Costs& costs, const Priced& priced,
                 const TourRequest& request, const TourObserver& observer, TourResult& tour) {
  const int n = stops.size();
  if (!priced.empty()) tour.priced = std::int64_t{n} * (n - 1) / 2;
  Orders found = orders_and_bound(costs, costs, stops, request, priced.scale(), observer, tour);
  if (found.orders.empty()) return false;
  bool proven = found.optimal && !priced.empty() && !by_ants(request);
  if (proven && is_routed(request)) {  // not by whole numbers
    Poller poller(request.stop);
    auto exact = exact_routes(stops.routes, n, priced.lengths(), poller);
    proven = exact.has_value();
    if (exact) found.orders = std::move(*exact);
  } else if (proven) {
    found.orders = {tour::subset_order(n, priced.lengths(), stops.ends, stops.given)};
  }
  tour.status = status_after(found.cause, request.stop);
  set_orders(request, stops, found, tour);
  tour.lower_bound = static_cast<double>(found.bound) / priced.scale();
  return proven;
}

// Once the legs are planned.
void conclude(bool proven, TourResult& tour) {
  if (tour.order.empty()) return;
  sum_up(tour);
  if (proven)
    tour.lower_bound = tour.length;
  else if (*tour.lower_bound > 0 || tour.length == 0)
    tour.lower_bound = std::min(tour.length, *tour.lower_bound);
  else
    tour.lower_bound.reset();
  settle_optimal(tour);
}

}  // namespace

std::optional<double> TourResult::gap() const {
  if (!lower_bound || status == Status::invalid || order.empty()) return std::nullopt;
  const double sum = cost.value_or(length);
  if (sum == 0) return 0;
  if (*lower_bound <= 0) return std::nullopt;
  return (sum - *lower_bound) / *lower_bound;
}

TourResult plan_tour(const Planner& unprepared, const TourRequest& request,
                     const TourObserver& observer) {
  TourResult tour;
  const TourStops stops = stops_of(unprepared, request, tour);
  const std::vector<Point>& places = stops.places;
  const int n = stops.size();
  if (n == 0) return tour;
  if (request.stop.token.stop_requested()) {
    tour.status = Status::interrupted;
    return tour;
  }

  const Planner planner = tour::prepared_for(unprepared, n, request.threads, request.stop);

  tour::MapPricer pricer(planner, places, request.stop);
  Priced priced;
  const bool ants = by_ants(request);
  if (tour::priced_at_once(planner, n) || (is_routed(request) && n <= kRoutedAtOnce) ||
      (ants && n <= tour::kMostForAnts)) {
    if (auto lengths = planner.distances(places, places, request.threads, request.stop))
      priced = Priced(std::move(*lengths), tour::kGrains);
  }
  if (priced.empty() && n > tour::kMostBySubsets) pricer.price_near(request.threads);
  const Costs costs = priced.empty() ? Costs(n, pricer) : priced.costs(n);
  const bool proven = order_stops(stops, costs, priced, request, observer, tour);
  if (priced.empty()) tour.priced = pricer.priced();
  plan_legs(planner, stops.points, request.threads, tour);
  conclude(proven, tour);
  return tour;
}

TourResult plan_tour(const TourWorld& world, const TourRequest& request,
                     const TourObserver& observer) {
  TourResult tour;
  const std::vector<Point> points = points_of(request);
  check(request, static_cast<int>(points.size()));
  const TourStops stops = stops_of(places_of(world, points), request, tour);
  const int n = stops.size();
  if (n == 0) return tour;
  if (n > kMostInWorld)
    refuse(number_text(n) + " stops are too many for a tour in this world",
           "give at most " + number_text(kMostInWorld));
  auto lengths = world.distances(stops.places, request.threads, without_deadline(request.stop));
  if (!lengths) {
    tour.status = Status::interrupted;
    return tour;
  }
  const double scale = tour::scale_of(*lengths);
  const Priced priced(std::move(*lengths), scale);
  const bool proven = order_stops(stops, priced.costs(n), priced, request, observer, tour);
  parallel_for(static_cast<int>(tour.legs.size()), thread_count(request.threads), [&](int i, int) {
    TourLeg& leg = tour.legs[i];
    leg.path = world.leg(points[leg.from], points[leg.to]);
    leg.length = path_length(leg.path);
  });
  conclude(proven, tour);
  return tour;
}

TourResult plan_tour(const Tsplib& problem, const TourRequest& request,
                     const TourObserver& observer) {
  check(request, problem.size);
  if (is_routed(request))
    refuse("problems of TSPLIB have no groups and no robots", "leave them out");
  const int n = problem.size;
  const Costs costs(n, problem.matrix.data());
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  tour::Ends ends{request.open, request.start.value_or(-1), request.goal.value_or(-1)};
  PartialOrder given = given_order(request, all, n);
  if (problem.ordered) {
    std::vector<Before> relation;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        if (a != b && costs(a, b) < 0) relation.emplace_back(b, a);
    check_circle(n, relation);
    ends = {true, 0, n - 1};
    given = {n, relation};
  }
  TourResult tour;
  auto [found, bound] = order_and_bound(costs, costs, ends, problem.places, given, request, 1,
                                        observer, all, tour, !problem.ordered);
  tour.priced = std::int64_t{n} * (n - 1) / (problem.ordered ? 1 : 2);
  if (found.order.empty()) {
    tell_no_order(given, ends, found, all, by_ants(request), tour);
    return tour;
  }
  tour.status = status_after(found.cause, request.stop);
  tour.order = std::move(found.order);
  tour.length = static_cast<double>(found.cost);
  tour.optimal = bound == found.cost;
  if (bound > 0 || tour.optimal || found.optimal) tour.lower_bound = static_cast<double>(bound);
  return tour;
}

}  // namespace lasius
