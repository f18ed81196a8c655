// Tours over points of any coordinates, and over costs.
#include <gtest/gtest.h>

#include <limits>

#include "core/tour/map_pricer.h"
#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "lasius/tour/tour.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/rooms.h"
#include "tests/oracle/least_tour.h"

namespace lasius {
namespace {

TEST(Distances, AndToursOfPoints) {
  const Planner plain(rooms());
  for (const Planner& planner :
       {plain, plain.prepared({.threads = 1}), plain.prepared({.threads = 1, .labels = true}),
        Planner(rooms(), Disc{0.4})}) {
    std::vector<Point> points;
    unsigned word = 7;
    while (points.size() < 20) {  // a seventh of a cell apart: corners and borders among them
      word = word * 1664525u + 1013904223u;
      const Point p{(word >> 8) % 420 / 7.0, (word >> 17) % 280 / 7.0};
      if (planner.clear_at(p)) points.push_back(p);
    }
    const Params exact("exact");
    const auto all = planner.distances(points, points, 2);
    ASSERT_TRUE(all);
    for (std::size_t a = 0; a < points.size(); ++a)
      for (std::size_t b = 0; b < points.size(); ++b) {
        const Result found =
            planner.plan({.start_point = points[a], .goal_point = points[b]}, exact);
        EXPECT_EQ(planner.joined_at(points[a], points[b]), !found.path.empty());
        EXPECT_NEAR((*all)[a * points.size() + b], found.length, 1e-9 * (1 + found.length));
      }
    TourRequest request;
    request.points = points;
    request.points.push_back({30.5, 3.25});  // in a wall
    request.points.push_back({60.01, 3});
    const TourResult tour = plan_tour(planner, request);
    ASSERT_EQ(tour.order.size(), points.size());
    ASSERT_EQ(tour.left_out.size(), 2U);
    EXPECT_EQ(tour.left_out[0].why, "stop 20 at (30.5, 3.25) is blocked");
    EXPECT_EQ(tour.left_out[1].why, "stop 21 at (60.01, 3) is outside the map");
    for (const TourLeg& leg : tour.legs) {
      EXPECT_EQ(leg.path.front(), points[leg.from]);
      EXPECT_EQ(leg.path.back(), points[leg.to]);
    }
    EXPECT_LE(*tour.lower_bound, tour.length);
    EXPECT_LT(*tour.gap(), 0.05);
  }
  EXPECT_THROW(
      static_cast<void>(plain.distances(std::vector<Point>{{30.5, 3}}, std::vector<Point>{{1, 1}})),
      Error);
  EXPECT_FALSE(plain.clear_at({30.5, 3.5}));
  EXPECT_TRUE(plain.clear_at({30, 3.5}));  // the border of a free cell
}

// In patches.
CostField patches() {
  std::vector<double> weights;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) weights.push_back(1 + (x / 5 + y / 7) % 4);
  return {60, 40, weights};
}

// The more time, the better: first the legs of an order that is short by straight ways are priced,
// then those between near stops, and no order is dearer than that one.
TEST(Tours, OverCostsAreNotDearerTheLaterTheyAreCut) {
  const CostField field = patches();
  const CostPlanner planner(Planner(rooms()), field);
  TourRequest request = ask(some_stops(rooms(), 16));
  request.threads = 1;
  request.generations = 2;
  int cut = 0;
  double before = std::numeric_limits<double>::infinity();
  for (int polls = 0; polls < 1 << 20; polls += 1 + (polls < 300 ? polls / 3 : polls)) {
    SCOPED_TRACE(polls);
    const CountingTime time(polls);
    request.stop = time.is_up();
    const TourResult tour = plan_tour(planner, request);
    ASSERT_EQ(tour.order.size(), request.stops.size());
    EXPECT_LE(*tour.cost, (1 + 1e-9) * before);
    before = std::min(before, *tour.cost);
    if (tour.status == Status::solved) break;
    ++cut;
  }
  EXPECT_GT(cut, 5);
}

TEST(Tours, OverCostsAreTheCheapestOfAllOrders) {
  const Grid grid = rooms();
  const CostField field = patches();
  const CostPlanner planner(Planner(grid), field);
  for (const int count : {1, 2, 5, 6}) {
    const std::vector<Cell> stops = some_stops(grid, count);
    std::vector<double> pair;
    for (const Cell from : stops)
      for (const Cell to : stops) pair.push_back(planner.plan({from, to}).cost);
    for (const int kind : {0, 1, 2, 3}) {
      if (count == 1 && kind == 3) continue;
      TourRequest request = ask(stops);
      request.open = kind > 0;
      if (kind > 1) request.start = 0;
      if (kind > 2) request.goal = count - 1;
      const TourResult tour = plan_tour(planner, request);
      ASSERT_EQ(tour.order.size(), static_cast<std::size_t>(count));
      double sum = 0;
      for (const TourLeg& leg : tour.legs) {
        EXPECT_EQ(leg.path.front(), centre(request.stops[leg.from]));
        EXPECT_EQ(leg.path.back(), centre(request.stops[leg.to]));
        EXPECT_NEAR(leg.length, path_length(leg.path), 1e-9);
        sum += leg.cost;
      }
      EXPECT_EQ(*tour.cost, sum);
      EXPECT_LE(*tour.lower_bound, sum);
      EXPECT_LE(*tour.gap(), 0.0025);
      const double best = oracle::LeastTour(request, pair).length();
      EXPECT_LE(sum, best * 1.003 + 1e-9);
      EXPECT_LE(*tour.lower_bound, best + 1e-9);
    }
  }
  TourRequest request = ask(some_stops(grid, 20));
  request.stop.deadline = Clock::now();
  const TourResult hurried = plan_tour(planner, request);
  EXPECT_EQ(hurried.order.size(), 20U);
  EXPECT_EQ(hurried.status, Status::limit);
  EXPECT_EQ(hurried.legs.size(), 20U);
  // Not one leg is priced in time: what straight ways cost at the least weight is a bound.
  EXPECT_EQ(hurried.priced, 0);
  ASSERT_TRUE(hurried.gap());
  request.stop = {};
  const TourResult whole = plan_tour(planner, request);
  EXPECT_LE(*hurried.lower_bound, *whole.cost);
  EXPECT_GE(*hurried.lower_bound, 0.3 * *whole.lower_bound);
  // Legs that are not priced are the dearer the longer: corners of a square are passed around it.
  request.stops = {{2, 2}, {8, 8}, {8, 2}, {2, 8}};
  request.stop.deadline = Clock::now();
  const TourResult square = plan_tour(planner, request);
  EXPECT_EQ(square.priced, 0);
  ASSERT_EQ(square.legs.size(), 4U);
  for (const TourLeg& leg : square.legs) {
    const Cell from = request.stops[leg.from], to = request.stops[leg.to];
    EXPECT_TRUE(from.x == to.x || from.y == to.y);
  }
  EXPECT_THROW(plan_tour(planner, ask(some_stops(grid, 201))), Error);
}

TEST(Tours, OfManyStopsArePricedAtOnceOnPreparedMaps) {
  const Planner plain(rooms()), prepared = plain.prepared({});
  EXPECT_TRUE(tour::priced_at_once(plain, 100));
  EXPECT_FALSE(tour::priced_at_once(plain, 101));
  EXPECT_TRUE(tour::priced_at_once(prepared, 1500));
  EXPECT_FALSE(tour::priced_at_once(prepared, 1501));
  EXPECT_FALSE(tour::priced_at_once(Planner(rooms(), PrepareOptions{}, Disc{1}), 101));
}

}  // namespace
}  // namespace lasius
