#include "lasius/tour.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.h"
#include "core/tour/ants/ant_colony.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/tour_steps.h"

namespace lasius {

namespace {

using tour::Before;
using tour::Cost;
using tour::Costs;
using tour::PartialOrder;

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
  const auto [points, indices, places, ends, given] = stops_of(unprepared, request, tour);
  const int n = static_cast<int>(indices.size());
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
  if (tour::priced_at_once(planner, n) || (ants && n <= tour::kMostForAnts)) {
    if (const auto lengths = planner.distances(places, places, request.threads, request.stop)) {
      for (const double length : *lengths) matrix.push_back(tour::grains(length));
      if (n <= tour::kMostBySubsets && !ants) exact_lengths = *lengths;
      tour.priced = std::int64_t{n} * (n - 1) / 2;
    }
  }
  const Costs costs = matrix.empty() ? Costs(n, pricer) : Costs(n, matrix.data());

  auto [found, bound] = order_and_bound(costs, costs, ends, places, given, request, tour::kGrains,
                                        observer, indices, tour);
  if (matrix.empty()) tour.priced = pricer.priced();
  if (found.order.empty()) {
    tell_no_order(given, ends, found, indices, ants, tour);
    return tour;
  }
  const bool proven = !exact_lengths.empty();
  if (proven)  // not by whole numbers
    found.order = tour::subset_order(n, exact_lengths, ends, given);

  tour.status = status_after(found.cause, request.stop);
  for (const int v : found.order) tour.order.push_back(indices[v]);
  plan_legs(planner, points, request.open, request.threads, tour);
  if (proven)
    tour.lower_bound = tour.length;
  else if (bound > 0 || tour.length == 0)
    tour.lower_bound = std::min(tour.length, static_cast<double>(bound) / tour::kGrains);
  constexpr double kRounding = 1e-9;
  tour.optimal = tour.gap() && *tour.gap() <= kRounding && tour.status == Status::solved;
  return tour;
}

TourResult plan_tour(const Tsplib& problem, const TourRequest& request,
                     const TourObserver& observer) {
  check(request, problem.size);
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
