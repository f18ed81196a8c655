#include "core/tour/tour_steps.h"

#include <chrono>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/tour/ants/ant_colony.h"
#include "core/tour/order/bound.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/route_tour.h"

namespace lasius {

using tour::Before;
using tour::Cost;
using tour::Costs;
using tour::PartialOrder;

namespace {

constexpr int kBoundRounds = 40;
constexpr double kGivenOrderShare = 0.8;  // of the time to a deadline

std::vector<Before> relation_of(const std::vector<std::vector<int>>& after) {
  std::vector<Before> relation;
  for (std::size_t b = 0; b < after.size(); ++b)
    for (const int a : after[b]) relation.emplace_back(a, static_cast<int>(b));
  return relation;
}

}  // namespace

std::vector<Point> points_of(const TourRequest& request) {
  if (!request.points.empty()) return request.points;
  std::vector<Point> points;
  for (const Cell c : request.stops) points.push_back(centre(c));
  return points;
}

// What is given of the order of some of the stops, by their places among these.
PartialOrder given_order(const TourRequest& request, const std::vector<int>& indices, int all) {
  std::vector<Before> relation = relation_of(request.after);
  std::vector<int> loads;
  for (const int i : indices)
    if (!request.load.empty()) loads.push_back(request.load[i]);
  const int n = static_cast<int>(indices.size());
  if (n != all) {  // over those that are left out, too
    const PartialOrder of_all(all, relation);
    relation.clear();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        if (of_all.before(indices[a], indices[b])) relation.emplace_back(a, b);
  }
  return {n, relation, std::move(loads), request.capacity.value_or(PartialOrder::kUnlimited)};
}

// `cause`: what ended the search for the order.
Status status_after(StopCondition::Cause cause, const StopCondition& stop) {
  if (cause == StopCondition::Cause::none) cause = stop.poll();
  return cause == StopCondition::Cause::token      ? Status::interrupted
         : cause == StopCondition::Cause::deadline ? Status::limit
                                                   : Status::solved;
}

std::int64_t target_of(std::int64_t bound, double gap) {
  constexpr double kMostGap = 1e6, kMost = 9e18;
  return static_cast<std::int64_t>(
      std::min(static_cast<double>(bound) * std::min(1 + gap, kMostGap), kMost));
}

void plan_legs(const Planner& planner, std::span<const Point> points, int threads,
               TourResult& tour) {
  std::vector<Workspace> workspaces(thread_count(threads));
  const Params exact("exact");
  parallel_for(static_cast<int>(tour.legs.size()), static_cast<int>(workspaces.size()),
               [&](int i, int thread) {
                 TourLeg& leg = tour.legs[i];
                 if (!leg.path.empty()) return;
                 Result planned =
                     planner.plan({.start_point = points[leg.from], .goal_point = points[leg.to]},
                                  exact, {.workspace = &workspaces[thread]});
                 leg.length = planned.length;
                 leg.path = std::move(planned.path);
               });
}

// Why no order whatever keeps what is given, where an end or a stop alone shows it; else empty.
std::string contradiction(const PartialOrder& given, const tour::Ends& ends,
                          std::span<const int> named) {
  const auto stop = [&](int v) { return "stop " + number_text(named[v]); };
  if (ends.start >= 0 && !given.previous(ends.start).empty())
    return stop(ends.start) + " is the start, but " + stop(given.previous(ends.start).front()) +
           " comes before it; start elsewhere, or let it come after";
  if (ends.goal >= 0 && !given.next(ends.goal).empty())
    return stop(ends.goal) + " is the goal, but " + stop(given.next(ends.goal).front()) +
           " comes after it; end elsewhere, or let it come before";
  std::int64_t least = 0;  // that may be carried
  for (int v = 0; v < static_cast<int>(named.size()); ++v) least += std::min(given.load(v), 0);
  for (int v = 0; v < static_cast<int>(named.size()); ++v)
    if (given.load(v) > 0 && least + given.load(v) > given.capacity())
      return stop(v) +
             (least < 0 ? " exceeds the capacity of " : " alone exceeds the capacity of ") +
             number_text(given.capacity()) + (least < 0 ? ", whatever comes before it" : "");
  return {};
}

// Of a tour that has no order: why.
void tell_no_order(const PartialOrder& given, const tour::Ends& ends, const tour::OrderFound& found,
                   std::span<const int> named, bool ants, TourResult& tour) {
  const bool proven = found.optimal;
  tour.status = proven ? Status::unreachable : Status::no_path;
  if (found.cause != StopCondition::Cause::none) tour.status = status_after(found.cause, {});
  tour.error = contradiction(given, ends, named);
  if (!tour.error.empty()) return;
  tour.error = std::string(proven ? "no order keeps " : "no order was found that keeps ") +
               "the capacity of " + number_text(given.capacity());
  if (ants) tour.error = "no ant has come to all stops";
}

StopCondition earlier(StopCondition stop, double share) {
  if (stop.deadline == Clock::time_point::max()) return stop;
  const auto now = stop.now();
  if (stop.deadline <= now) return stop;
  stop.deadline = deadline_in(share * std::chrono::duration<double>(stop.deadline - now), now);
  return stop;
}

// An order and its bound. `scale` is how many of a cost make a length; `named` the stops' indices.
Ordered order_and_bound(const Costs& costs, const Costs& lower, const tour::Ends& ends,
                        std::span<const Point> places, const PartialOrder& given,
                        const TourRequest& request, double scale, const TourObserver& observer,
                        std::span<const int> named, TourResult& tour, bool symmetric) {
  tour::OrderOptions options{
      .seed = request.seed,
      .generations = request.generations,
      .given = &given,
      .stop = earlier(request.stop, given.any_order() ? kOrderShare : kGivenOrderShare)};
  BestTold told(observer, named, scale);
  if (observer) options.observer = std::ref(told);
  Poller poller(request.stop);
  const bool ants = by_ants(request), own_bounds = &lower != &costs;
  const auto bound_of = [&](const tour::OrderFound& found) {
    if ((ants || own_bounds) && costs.size() <= tour::kMostBySubsets)
      return tour::cost_of(lower, tour::subset_order(lower, ends, given), ends.open);
    if (found.order.empty() || (found.optimal && !costs.priced_late())) return found.cost;
    if (!symmetric) return std::int64_t{0};
    return tour_bound(lower, ends, places, found.cost, kBoundRounds, poller);
  };
  Ordered early;
  if (request.target_gap > 0) {  // the first tour's bound tells how short is short enough
    tour::OrderOptions first = options;
    first.generations = 0;
    if (ants) first.observer = {};
    early.found = find_order(costs, ends, places, first);
    early.bound = bound_of(early.found);
    options.target = target_of(early.bound, request.target_gap);
    if (told.stopped()) early.found.cause = StopCondition::Cause::token;
    if (!ants && (early.found.order.empty() || early.found.cost <= options.target ||
                  early.found.cause != StopCondition::Cause::none))
      return early;
    if (!ants) options.first = early.found.order;
  }
  Ordered ordered;
  if (ants && !contradiction(given, ends, named).empty()) {
    ordered.found.optimal = true;
    return ordered;
  }
  if (ants) {
    ordered.found = find_order_by_ants(costs, ends, symmetric, request.ants, request.threads,
                                       options, tour.curves);
    for (auto* lengths : {&tour.curves.best, &tour.curves.mean})
      for (double& length : *lengths) length /= scale;
  } else {
    ordered.found = find_order(costs, ends, places, options);
  }
  if (told.stopped()) ordered.found.cause = StopCondition::Cause::token;
  if (!ants && !early.found.order.empty() && early.found.cost < ordered.found.cost) {
    early.found.cause = ordered.found.cause;
    return early;
  }
  ordered.bound = std::max(early.bound, bound_of(ordered.found));  // either holds of any order
  return ordered;
}

void check_circle(int n, const std::vector<Before>& relation) {
  const std::vector<int> circle = tour::circle_of(n, relation);
  if (circle.empty()) return;
  std::string text = "the order is a circle: ";
  for (const int stop : circle) text += "stop " + number_text(stop) + " before ";
  refuse(text + "stop " + number_text(circle.front()), "leave one of these out");
}

void check(const TourRequest& request, int n) {
  for (const auto& end : {request.start, request.goal})
    if (end && (*end < 0 || *end >= n))
      refuse("there is no stop " + number_text(*end), "give the index of one, from 0");
  validate(request.ants);
  if (request.generations < 0)
    refuse("generations are " + number_text(request.generations), "give 0 or more");
  for (const auto& [lists, size] :
       {std::pair("after", request.after.size()), {"load", request.load.size()}})
    if (size != 0 && size != static_cast<std::size_t>(n))
      refuse(std::string(lists) + " has " + number_text(size) + " entries",
             "give one a stop, " + number_text(n));
  for (const auto& before : request.after)
    for (const int stop : before)
      if (stop < 0 || stop >= n)
        refuse("there is no stop " + number_text(stop) + " to come before another",
               "give the index of one, from 0");
  check_circle(n, relation_of(request.after));
  if (request.capacity && *request.capacity < 0)
    refuse("the capacity is " + number_text(*request.capacity), "give 0 or more");
  if (!(request.target_gap >= 0))
    refuse("target gap is " + number_text(request.target_gap), "give 0 or more");
  check_routes(request, n);
}

TourStops stops_of(const StopPlaces& places, const TourRequest& request, TourResult& tour) {
  TourStops stops{.points = points_of(request)};
  const std::vector<Point>& points = stops.points;
  std::vector<int> indices = visited(places, request, tour);
  if (indices.empty() || !tour.error.empty()) {
    const auto clear = [&](int end) { return !places.regions[end].empty(); };
    const std::vector<int> ends = ends_of(request);
    const bool apart = !tour.error.empty() && std::all_of(ends.begin(), ends.end(), clear);
    tour.status = apart ? Status::unreachable : Status::invalid;
    if (tour.error.empty()) tour.error = "no stop is free";
    return stops;
  }
  for (const int i : indices) stops.places.push_back(points[i]);
  stops.given = given_order(request, indices, static_cast<int>(points.size()));
  stops.indices = std::move(indices);
  const auto inner = [&](const std::optional<int>& end) { return end ? stops.place_of(*end) : -1; };
  stops.ends = {request.open, inner(request.start), inner(request.goal)};
  if (is_routed(request)) add_routes(request, stops, tour);
  return stops;
}

TourStops stops_of(const Planner& planner, const TourRequest& request, TourResult& tour) {
  const std::vector<Point> points = points_of(request);
  check(request, static_cast<int>(points.size()));
  const StopPlaces places = places_of(planner, points, request.stop);
  if (places.cause == StopCondition::Cause::none) return stops_of(places, request, tour);
  tour.status = status_after(places.cause, request.stop);
  return {.points = points};
}

}  // namespace lasius
