#include "core/tour/route_tour.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/tour/order/search.h"
#include "core/tour/routes/find_routes.h"
#include "core/tour/routes/route_bound.h"
#include "core/tour/visited.h"

namespace lasius {

using tour::Costs;
using tour::RoutesFound;

namespace {

constexpr double kFirstBoundShare = 0.1;  // of the time to a deadline
constexpr int kMostRouted = 2000;         // stops, whose tasks are compared pair by pair

Orders routes_and_bound(const Costs& costs, const Costs& lower, const TourStops& stops,
                        const TourRequest& request, double scale, const TourObserver& observer) {
  const tour::RouteProblem& problem = stops.routes;
  tour::RouteOptions options{.seed = request.seed,
                             .generations = request.generations,
                             .stop = earlier(request.stop, kOrderShare)};
  BestTold told(observer, stops.indices, scale);
  if (observer)
    options.observer = [&](const RoutesFound& found) {
      std::vector<int> all;
      for (const auto& order : found.orders) all.insert(all.end(), order.begin(), order.end());
      return told(all, found.cost);
    };
  const StopCondition soon = earlier(request.stop, kFirstBoundShare);
  Poller poller(request.stop), for_first(soon);
  const bool own_bounds = &lower != &costs;
  const auto bound_of = [&](const RoutesFound& found, Poller& until) {
    if (found.optimal && !own_bounds && !costs.priced_late()) return found.cost;
    return own_bounds ? least_cost(problem, lower, request.open, found.cost, until)
                      : routes_bound(problem, lower, found.cost, until);
  };
  const auto answer = [&](RoutesFound&& found, std::int64_t bound) {
    return Orders{std::move(found.orders), bound, found.optimal,
                  told.stopped() ? StopCondition::Cause::token : found.cause};
  };
  std::optional<RoutesFound> early;
  std::int64_t early_bound = 0;
  if (request.target_gap > 0) {  // the first solution's bound tells how short is short enough
    tour::RouteOptions first = options;
    first.generations = 0;
    early = find_routes(problem, costs, first);
    early_bound = bound_of(*early, for_first);
    options.target = target_of(early_bound, request.target_gap);
    if (early->optimal || early->cost <= options.target || told.stopped() ||
        early->cause != StopCondition::Cause::none)
      return answer(std::move(*early), early_bound);
  }
  RoutesFound found = find_routes(problem, costs, options);
  if (early && early->cost < found.cost) {
    early->cause = found.cause;
    return answer(std::move(*early), early_bound);
  }
  const std::int64_t bound =
      std::max(early_bound, bound_of(found, poller));  // either holds of any routes
  return answer(std::move(found), bound);
}

}  // namespace

void check_routes(const TourRequest& request, int n) {
  if (request.most_stops < 0)
    refuse("the most stops of a robot are " + number_text(request.most_stops), "give 0 or more");
  if (request.most_stops > 0 && request.robots.empty())
    refuse("the most stops of a robot are given, but no robots", "name the stops where they begin");
  if (!is_routed(request)) return;
  const std::string what = request.robots.empty() ? "groups" : "several robots";
  if (n > kMostRouted)
    refuse(number_text(n) + " stops are too many for a tour with " + what,
           "give at most " + number_text(kMostRouted));
  if (by_ants(request)) refuse("ants know no tours with " + what, "leave the algorithm out");
  if (!request.after.empty() || !request.load.empty() || request.capacity)
    refuse("tours with " + what + " have no order given in part",
           "leave after, load and capacity out, or the " + what);
  if (!request.group.empty() && request.group.size() != static_cast<std::size_t>(n))
    refuse("group has " + number_text(request.group.size()) + " entries",
           "give one a stop, " + number_text(n));
  if (!request.robots.empty() && (request.start || request.goal))
    refuse("several robots have no other start and no goal", "leave start and goal out");
  tour::check_ends(n, {request.open, request.start.value_or(-1), request.goal.value_or(-1)});
  const std::vector<int> ends = ends_of(request);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i] < 0 || ends[i] >= n)
      refuse("there is no stop " + number_text(ends[i]) + " for a robot to begin at",
             "give the index of one, from 0");
    for (std::size_t j = 0; j < i; ++j) {
      if (ends[i] == ends[j] && !request.robots.empty())
        refuse("two robots begin at stop " + number_text(ends[i]),
               "give each a stop of its own, at the same place if need be");
      if (ends[i] != ends[j] && !request.group.empty() && request.group[ends[i]] >= 0 &&
          request.group[ends[i]] == request.group[ends[j]])
        refuse("stops " + number_text(ends[j]) + " and " + number_text(ends[i]) +
                   " are both ends of the tour and of group " + number_text(request.group[ends[i]]),
               "of a group one stop is visited; give them groups of their own");
    }
  }
}

void add_routes(const TourRequest& request, TourStops& stops, TourResult& tour) {
  tour::RouteProblem& routes = stops.routes;
  routes.most = request.most_stops;
  for (const int robot : request.robots)
    routes.routes.push_back({request.open, stops.place_of(robot), -1});
  if (request.robots.empty()) routes.routes.push_back(stops.ends);
  const std::vector<int> ends = ends_of(request);
  const auto group_of = [&](int i) { return request.group.empty() ? -1 : request.group[i]; };
  std::map<int, int> task_of;
  for (const int end : ends)
    if (group_of(end) >= 0) task_of[group_of(end)] = -1;  // done there
  for (int v = 0; v < stops.size(); ++v) {
    const int i = stops.indices[v], group = group_of(i);
    if (std::count(ends.begin(), ends.end(), i) > 0) continue;
    const auto known = group >= 0 ? task_of.find(group) : task_of.end();
    if (known == task_of.end()) {
      if (group >= 0) task_of[group] = routes.size();
      routes.tasks.push_back({v});
    } else if (known->second >= 0) {
      routes.tasks[known->second].push_back(v);
    }
  }
  const auto robots = static_cast<std::int64_t>(routes.routes.size());
  if (routes.size() <= routes.room() * robots) return;
  tour.status = Status::unreachable;
  tour.error = number_text(robots) + (robots == 1 ? " robot has" : " robots have") +
               " no room for " + number_text(routes.size()) + " stops, at most " +
               number_text(request.most_stops) + " each";
  stops.indices.clear();
}

Orders orders_and_bound(const Costs& costs, const Costs& lower, const TourStops& stops,
                        const TourRequest& request, double scale, const TourObserver& observer,
                        TourResult& tour) {
  if (is_routed(request)) return routes_and_bound(costs, lower, stops, request, scale, observer);
  auto [found, bound] = order_and_bound(costs, lower, stops.ends, stops.places, stops.given,
                                        request, scale, observer, stops.indices, tour);
  if (!found.order.empty()) return {{std::move(found.order)}, bound, found.optimal, found.cause};
  tell_no_order(stops.given, stops.ends, found, stops.indices, by_ants(request), tour);
  return {};
}

void add_legs(std::span<const int> order, bool open, TourResult& tour) {
  for (const auto& [from, to] : tour::legs_of({{order.begin(), order.end()}}, open))
    tour.legs.push_back({from, to, 0, {}, 0});
}

void settle_optimal(TourResult& tour) {
  constexpr double kRounding = 1e-9;
  tour.optimal = tour.gap() && *tour.gap() <= kRounding;
}

void set_orders(const TourRequest& request, const TourStops& stops, const Orders& found,
                TourResult& tour) {
  for (const std::vector<int>& places : found.orders) {
    std::vector<int> order;
    order.reserve(places.size());
    for (const int v : places) order.push_back(stops.indices[v]);
    const auto first = static_cast<int>(tour.legs.size());
    add_legs(order, request.open, tour);
    const auto count = static_cast<int>(tour.legs.size()) - first;
    tour.order.insert(tour.order.end(), order.begin(), order.end());
    if (!request.robots.empty()) tour.tours.push_back({order.front(), order, first, count, 0, 0});
  }
}

void sum_up(TourResult& tour) {
  for (const TourLeg& leg : tour.legs) tour.length += leg.length;
  if (tour.cost)
    for (const TourLeg& leg : tour.legs) *tour.cost += leg.cost;
  for (RobotTour& robot : tour.tours)
    for (int i = 0; i < robot.legs; ++i) {
      robot.length += tour.legs[robot.first_leg + i].length;
      robot.cost += tour.legs[robot.first_leg + i].cost;
    }
}

}  // namespace lasius
