// Tours over few stops with every option, against the least that there is.
#include "lasius/tour/tour.h"

#include <algorithm>
#include <array>

#include "bench/hunt/drawing.h"
#include "tests/oracle/least_tour.h"
#include "tests/oracle/visibility_graph.h"

namespace lasius::bench {
namespace {

constexpr int kFew = 6;  // stops, of more less is asked

// Whether an order of one robot keeps what is given of it, and visits all.
bool keeps_order(const TourRequest& request, const TourResult& got) {
  std::vector<bool> visited(request.stops.size(), false);
  std::int64_t carried = 0;
  for (const int stop : got.order) {
    const auto s = static_cast<std::size_t>(stop);
    if (visited[s]) return false;
    for (std::size_t b = 0; !request.after.empty() && b < request.after[s].size(); ++b)
      if (!visited[static_cast<std::size_t>(request.after[s][b])]) return false;
    if (request.capacity && (carried += request.load[s]) > *request.capacity) return false;
    visited[s] = true;
  }
  return std::ranges::all_of(visited, [](bool v) { return v; }) &&
         (!request.start || got.order.front() == *request.start) &&
         (!request.goal || got.order.back() == *request.goal);
}

tour::AntParams draw_ants(HuntDraw& draw) {
  constexpr std::array kFamilies{"as", "eas", "ras", "mmas", "acs", "has-sop", "eacs"};
  tour::AntParams ants(draw.pick(kFamilies));
  ants.iterations = draw.between(1, 5);
  if (draw.one_in(2)) ants.local_search = tour::Improvement::pieces;
  return ants;
}

TourRequest draw_tour(HuntDraw& draw, const std::vector<Cell>& stops) {
  const int count = static_cast<int>(stops.size());
  TourRequest request;
  request.stops = stops;
  request.seed = draw.any() >> 12;
  request.open = draw.one_in(2);
  // Plain, order given in part, tasks, robots.
  const int kind = draw.between(0, count > kFew ? 1 : 3);
  if (kind < 3 && draw.one_in(2)) request.start = draw.between(0, count - 1);
  if (kind < 3 && request.open && draw.one_in(2)) {
    request.goal = draw.between(0, count - 1);
    if (request.start == request.goal) request.goal.reset();
  }
  if (kind == 1) {
    request.after.resize(stops.size());
    for (int i = draw.between(0, 3); i > 0; --i) {
      const int a = draw.between(0, count - 1), b = draw.between(0, count - 1);
      if (a < b) request.after[static_cast<std::size_t>(b)].push_back(a);  // hence no cycle
    }
    if (draw.one_in(2)) {
      for (int i = 0; i < count; ++i) request.load.push_back(draw.between(-2, 2));
      request.capacity = draw.between(1, 4);
    }
  }
  if (kind >= 2) {
    for (int i = 0; i < count; ++i)
      request.group.push_back(draw.one_in(2) ? draw.between(0, 1) : -1);
    if (kind == 3) {
      request.robots = {0};
      if (count > 3 && draw.one_in(2)) request.robots.push_back(1);
      if (draw.one_in(3)) request.most_stops = draw.between(1, 4);
    }
    // Whoever is there in any case is a task of its own.
    for (const int stop : request.robots) request.group[static_cast<std::size_t>(stop)] = -1;
    for (const auto& end : {request.start, request.goal})
      if (end) request.group[static_cast<std::size_t>(*end)] = -1;
  }
  return request;
}

}  // namespace

void judge_tour(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  const Planner planner(Grid(problem.grid));
  const oracle::VisibilityGraph oracle(problem.grid);
  std::vector<Cell> stops;  // those that are joined to the first
  for (const Cell place : problem.places)
    if (oracle.shortest(problem.places[0], place)) stops.push_back(place);
  if (stops.size() < 2) return;
  std::vector<double> legs;
  for (const Cell a : stops)
    for (const Cell b : stops) legs.push_back(oracle.shortest(a, b)->length);

  for (int i = 0; i < (stops.size() > kFew ? 2 : 8); ++i) {
    TourRequest request = draw_tour(draw, stops);
    const bool one = request.group.empty() && request.robots.empty();
    const double best = oracle::LeastTour(request, legs).length();
    const bool ants = one && draw.one_in(4);
    if (ants) request.ants = draw_ants(draw);
    if (stops.size() > kFew) request.generations = draw.between(0, 2);
    const TourResult got = plan_tour(planner, request);
    double sum = 0;
    std::string fault;
    for (const TourLeg& leg : got.legs) {
      sum += leg.length;
      if (fault.empty())
        fault =
            path_fault(problem.grid, leg.path, centre(stops[static_cast<std::size_t>(leg.from)]),
                       centre(stops[static_cast<std::size_t>(leg.to)]), leg.length);
    }
    const auto right = [&] {
      // Where an order is given in part, a search and ants may find none.
      const bool may_fail =
          (ants || stops.size() > 12) && !(request.after.empty() && !request.capacity);
      if (got.order.empty())
        return std::isinf(best) ? got.status == Status::unreachable || may_fail
                                : may_fail && got.status == Status::no_path;
      if (got.status != Status::solved || !fault.empty() || !same_length(sum, got.length))
        return false;
      if (one && !keeps_order(request, got)) return false;
      const bool exact = !ants && stops.size() <= 12;
      return got.length >= best - 1e-9 * (1 + best) && (!exact || got.optimal) &&
             (!got.optimal || same_length(got.length, best)) &&
             got.lower_bound.value_or(0) <= best * (1 + 1e-9);
    };
    verdict.expect(right(), [&] {
      return sentence("tour ", i, " by ", request.ants.algorithm(), ": ", to_string(got.status),
                      got.optimal ? ", optimal, " : ", ", got.length, " above ",
                      got.lower_bound.value_or(-1), " in place of ", best, ' ', got.error, fault);
    });
  }
}

}  // namespace lasius::bench
