// Tours of groups and of several robots: from a request to its routes and back.
#pragma once

#include <span>
#include <vector>

#include "core/tour/tour_steps.h"

namespace lasius {

inline bool is_routed(const TourRequest& request) {
  return !request.group.empty() || !request.robots.empty();
}

/// @throws Error(invalid_parameter), as plan_tour, for what it says of groups and robots.
void check_routes(const TourRequest& request, int n);

/// The routes over the stops that are visited. Where they have no room for all tasks, `tour` says
/// so and no stop is left.
void add_routes(const TourRequest& request, TourStops& stops, TourResult& tour);

/// Orders of a tour's stops, by their places, and a bound.
struct Orders {
  std::vector<std::vector<int>> orders = {};  ///< one a robot; none where there is no tour
  std::int64_t bound = 0;
  bool optimal = false;
  StopCondition::Cause cause = StopCondition::Cause::none;
};

/// Of all tours on maps, routed or not, as order_and_bound. Where there is none `tour` says why.
Orders orders_and_bound(const tour::Costs& costs, const tour::Costs& lower, const TourStops& stops,
                        const TourRequest& request, double scale, const TourObserver& observer,
                        TourResult& tour);

/// Sets the orders by the stops' indices, and the legs' ends.
void set_orders(const TourRequest& request, const TourStops& stops, const Orders& found,
                TourResult& tour);
/// The ends of the legs of an order, behind those that are there.
void add_legs(std::span<const int> order, bool open, TourResult& tour);
/// Sums up the legs, once they are planned.
void sum_up(TourResult& tour);
/// Whether length (or cost) and bound, once they are known, prove the tour shortest.
void settle_optimal(TourResult& tour);

}  // namespace lasius
