#include "core/tour/tour_steps.h"

#include <algorithm>
#include <chrono>

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/tour/ants/ant_colony.h"
#include "core/tour/order/bound.h"
#include "core/tour/order/subset_dp.h"
#include "lasius/error.h"

namespace lasius {

using tour::Before;
using tour::Cost;
using tour::Costs;
using tour::PartialOrder;

namespace {

constexpr int kBoundRounds = 10;
constexpr double kOrderShare = 0.6, kGivenOrderShare = 0.8;
constexpr double kMostTarget = 1e6;  // of a target, in bounds

// As it was given.
std::string stop_name(const TourRequest& request, int i) {
  if (!request.points.empty()) return pair_text(request.points[i].x, request.points[i].y);
  return pair_text(request.stops[i].x, request.stops[i].y);
}

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

// The stops that a tour visits, by their index in the request.
std::vector<int> visited(const Planner& planner, const TourRequest& request,
                         std::span<const Point> points, TourResult& tour) {
  const int n = static_cast<int>(points.size());
  std::vector<std::vector<int>> regions;
  std::vector<int> region_of(n, -1);
  for (int i = 0; i < n; ++i) {
    const Point p = points[i];
    if (!planner.clear_at(p)) continue;
    const auto joined = [&](const auto& r) { return planner.joined_at(points[r.front()], p); };
    const auto region = std::find_if(regions.begin(), regions.end(), joined);
    region_of[i] = static_cast<int>(region - regions.begin());
    if (region == regions.end())
      regions.push_back({i});
    else
      region->push_back(i);
  }
  int chosen = 0;
  for (int r = 1; r < static_cast<int>(regions.size()); ++r)
    if (regions[r].size() > regions[chosen].size()) chosen = r;
  if (request.goal && region_of[*request.goal] >= 0) chosen = region_of[*request.goal];
  if (request.start && region_of[*request.start] >= 0) chosen = region_of[*request.start];
  for (int i = 0; i < n; ++i) {
    if (region_of[i] == chosen && !regions.empty()) continue;
    const Point p = points[i];
    const Grid& map = planner.grid();
    const bool inside = p.x >= 0 && p.x <= map.width() && p.y >= 0 && p.y <= map.height();
    tour.left_out.push_back({i, "stop " + number_text(i) + " at " + stop_name(request, i) +
                                    (!inside            ? " is outside the map"
                                     : region_of[i] < 0 ? " is blocked"
                                                        : " cannot be reached from the others")});
    if (i == request.start || i == request.goal) tour.error = tour.left_out.back().why;
  }
  return regions.empty() ? std::vector<int>{} : regions[chosen];
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

void plan_legs(const Planner& planner, std::span<const Point> points, bool open, int threads,
               TourResult& tour) {
  const auto n = static_cast<int>(tour.order.size());
  tour.legs.resize(n == 1 ? 0 : open ? n - 1 : n);
  std::vector<Workspace> workspaces(thread_count(threads));
  const Params exact("exact");
  parallel_for(static_cast<int>(tour.legs.size()), static_cast<int>(workspaces.size()),
               [&](int i, int thread) {
                 const int a = tour.order[i], b = tour.order[(i + 1) % n];
                 Result leg = planner.plan({.start_point = points[a], .goal_point = points[b]},
                                           exact, &workspaces[thread]);
                 tour.legs[i] = {a, b, leg.length, std::move(leg.path)};
               });
  for (const TourLeg& leg : tour.legs) tour.length += leg.length;
}

// Why no order whatever keeps what is given, where an end or a stop alone shows it; else empty.
std::string contradiction(const PartialOrder& given, const tour::Ends& ends,
                          std::span<const int> named) {
  const auto stop = [&](int v) { return "stop " + number_text(named[v]); };
  if (ends.start >= 0 && !given.previous(ends.start).empty())
    return stop(ends.start) + " is the start, but " + stop(given.previous(ends.start).front()) +
           " comes before it";
  if (ends.goal >= 0 && !given.next(ends.goal).empty())
    return stop(ends.goal) + " is the goal, but " + stop(given.next(ends.goal).front()) +
           " comes after it";
  for (int v = 0; v < static_cast<int>(named.size()); ++v)
    if (given.load(v) > given.capacity())
      return stop(v) + " alone exceeds the capacity of " + number_text(given.capacity());
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

// An order and its bound. `scale` is how many of a cost make a length; `named` the stops' indices.
Ordered order_and_bound(const Costs& costs, const Costs& lower, const tour::Ends& ends,
                        std::span<const Point> places, const PartialOrder& given,
                        const TourRequest& request, double scale, const TourObserver& observer,
                        std::span<const int> named, TourResult& tour, bool symmetric) {
  tour::OrderOptions options{.seed = request.seed,
                             .generations = request.generations,
                             .given = &given,
                             .stop = request.stop};
  if (request.stop.deadline != Clock::time_point::max()) {
    const auto now = request.stop.now();
    options.stop.deadline =
        deadline_in((given.any_order() ? kOrderShare : kGivenOrderShare) *
                        std::chrono::duration<double>(request.stop.deadline - now),
                    now);
  }
  std::vector<int> told;
  if (observer)
    options.observer = [&](std::span<const int> order, std::int64_t cost) {
      told.clear();
      for (const int v : order) told.push_back(named[v]);
      return observer(told, static_cast<double>(cost) / scale);
    };
  Poller poller(request.stop);
  const bool ants = by_ants(request), own_bounds = &lower != &costs;
  const auto bound_of = [&](const tour::OrderFound& found) {
    if ((ants || own_bounds) && costs.size() <= tour::kMostBySubsets)
      return tour::cost_of(lower, tour::subset_order(lower, ends, given), ends.open);
    if (found.order.empty() || (found.optimal && !costs.priced_late())) return found.cost;
    if (!symmetric) return std::int64_t{0};
    return tour_bound(lower, ends, places, found.cost, kBoundRounds, poller);
  };
  if (request.target_gap > 0) {  // the first tour's bound tells how short is short enough
    tour::OrderOptions first = options;
    first.generations = 0;
    Ordered early{.found = find_order(costs, ends, places, first)};
    early.bound = bound_of(early.found);
    options.target = static_cast<std::int64_t>(static_cast<double>(early.bound) *
                                               std::min(1 + request.target_gap, kMostTarget));
    if (!ants && (early.found.order.empty() || early.found.cost <= options.target)) return early;
  }
  Ordered ordered;
  if (ants && !contradiction(given, ends, named).empty()) {
    ordered.found.optimal = true;
    return ordered;
  }
  if (ants) {
    ordered.found = find_order_by_ants(costs, ends, symmetric, request.ants, request.threads,
                                       options, tour.run);
    for (auto* lengths : {&tour.run.best, &tour.run.mean})
      for (double& length : *lengths) length /= scale;
  } else {
    ordered.found = find_order(costs, ends, places, options);
  }
  ordered.bound = bound_of(ordered.found);
  return ordered;
}

void check_circle(int n, const std::vector<Before>& relation) {
  const std::vector<int> circle = tour::circle_of(n, relation);
  if (circle.empty()) return;
  std::string text = "the order is a circle: ";
  for (const int stop : circle) text += "stop " + number_text(stop) + " before ";
  throw Error(ErrorCode::invalid_parameter, text + "stop " + number_text(circle.front()),
              "leave one of these out");
}

void check(const TourRequest& request, int n) {
  for (const auto& end : {request.start, request.goal})
    if (end && (*end < 0 || *end >= n))
      throw Error(ErrorCode::invalid_parameter, "there is no stop " + number_text(*end),
                  "give the index of one, from 0");
  validate(request.ants);
  if (request.generations < 0)
    throw Error(ErrorCode::invalid_parameter, "generations are " + number_text(request.generations),
                "give 0 or more");
  const auto refuse = [](const std::string& problem, const std::string& remedy) {
    throw Error(ErrorCode::invalid_parameter, problem, remedy);
  };
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
    throw Error(ErrorCode::invalid_parameter, "target gap is " + number_text(request.target_gap),
                "give 0 or more");
}

TourStops stops_of(const Planner& planner, const TourRequest& request, TourResult& tour) {
  TourStops stops{
      .points = points_of(request), .indices = {}, .places = {}, .ends = {}, .given = {}};
  const std::vector<Point>& points = stops.points;
  check(request, static_cast<int>(points.size()));
  std::vector<int> indices = visited(planner, request, points, tour);
  if (indices.empty() || !tour.error.empty()) {
    const auto bad = [&](const std::optional<int>& end) {
      return end && !planner.clear_at(points[*end]);
    };
    const bool apart = !tour.error.empty() && !bad(request.start) && !bad(request.goal);
    tour.status = apart ? Status::unreachable : Status::invalid;
    if (tour.error.empty()) tour.error = "no stop is a free cell of the map";
    return stops;
  }
  const auto inner = [&](const std::optional<int>& end) {
    return end ? static_cast<int>(std::find(indices.begin(), indices.end(), *end) - indices.begin())
               : -1;
  };
  for (const int i : indices) stops.places.push_back(points[i]);
  stops.ends = {request.open, inner(request.start), inner(request.goal)};
  stops.given = given_order(request, indices, static_cast<int>(points.size()));
  stops.indices = std::move(indices);
  return stops;
}

}  // namespace lasius
