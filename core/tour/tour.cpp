#include "lasius/tour.h"

#include <algorithm>
#include <numeric>

#include "core/tour/ants/ant_colony.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/route_tour.h"
#include "core/tour/routes/exact_routes.h"
#include "lasius/error.h"

namespace lasius {

namespace {

using tour::Before;
using tour::Cost;
using tour::Costs;
using tour::PartialOrder;

constexpr int kRoutedAtOnce = 500;  // of groups and robots, whose search and bound ask for most

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

  const Planner planner = tour::prepared_for(unprepared, n, request.threads, request.stop);
  if (request.stop.token.stop_requested()) {
    tour.status = Status::interrupted;  // before there was an order
    return tour;
  }

  tour::MapPricer pricer(planner, places, request.stop);
  std::vector<Cost> matrix;
  std::vector<double> exact_lengths;
  const bool ants = by_ants(request);
  if (tour::priced_at_once(planner, n) || (is_routed(request) && n <= kRoutedAtOnce) ||
      (ants && n <= tour::kMostForAnts)) {
    if (const auto lengths = planner.distances(places, places, request.threads, request.stop)) {
      for (const double length : *lengths) matrix.push_back(tour::grains(length));
      if (!ants && (n <= tour::kMostBySubsets || is_routed(request))) exact_lengths = *lengths;
      tour.priced = std::int64_t{n} * (n - 1) / 2;
    }
  }
  const Costs costs = matrix.empty() ? Costs(n, pricer) : Costs(n, matrix.data());

  Orders found = orders_and_bound(costs, costs, stops, request, tour::kGrains, observer, tour);
  if (matrix.empty()) tour.priced = pricer.priced();
  if (found.orders.empty()) return tour;
  bool proven = found.optimal && !exact_lengths.empty();
  if (proven && is_routed(request)) {  // not by whole numbers
    Poller poller(request.stop);
    auto exact = exact_routes(stops.routes, n, exact_lengths, poller);
    proven = exact.has_value();
    if (exact) found.orders = std::move(*exact);
  } else if (proven) {
    found.orders = {tour::subset_order(n, exact_lengths, stops.ends, stops.given)};
  }

  tour.status = status_after(found.cause, request.stop);
  set_orders(request, stops, found, tour);
  plan_legs(planner, stops.points, request.threads, tour);
  sum_up(tour);
  if (proven)
    tour.lower_bound = tour.length;
  else if (found.bound > 0 || tour.length == 0)
    tour.lower_bound = std::min(tour.length, static_cast<double>(found.bound) / tour::kGrains);
  settle_optimal(tour);
  return tour;
}

TourResult plan_tour(const Tsplib& problem, const TourRequest& request,
                     const TourObserver& observer) {
  check(request, problem.size);
  if (is_routed(request))
    throw Error(ErrorCode::invalid_parameter, "problems of TSPLIB have no groups and no robots",
                "leave them out");
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
  if (!problem.ordered || bound > 0 || found.optimal) tour.lower_bound = static_cast<double>(bound);
  tour.optimal = bound == found.cost;
  return tour;
}

}  // namespace lasius
