#include "lasius/tour/tour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "lasius/polygon/plan.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/least_tour.h"

namespace lasius::polygon {
namespace {

Ring box(double x, double y, double width, double height, double unit) {
  return {{unit * x, unit * y},
          {unit * (x + width), unit * y},
          {unit * (x + width), unit * (y + height)},
          {unit * x, unit * (y + height)}};
}

// Two rooms that a wall with a door parts, a pillar in each; behind a ring nobody can be reached.
Planner rooms(double unit = 1) {
  World world;
  world.boundary.outer = box(0, 0, 40, 20, unit);
  for (const Ring& ring : {box(19, 0, 2, 8, unit), box(19, 11, 2, 9, unit), box(6, 6, 5, 5, unit),
                           box(28, 4, 4, 9, unit)})
    world.obstacles.push_back({ring, {}});
  world.obstacles.push_back({box(35, 15, 4, 4, unit), {box(36, 16, 2, 2, unit)}});
  return Planner(world);
}

std::vector<Point> some_stops(double unit = 1) {
  std::vector<Point> stops;
  for (const Point p : {Point{2, 3}, {5, 8}, {12, 9}, {24, 10}, {33, 6}, {26, 3}, {16, 18}})
    stops.push_back({unit * p.x, unit * p.y});
  return stops;
}

TEST(PolygonTours, AreTheShortestOfAllOrders) {
  const Planner planner = rooms();
  TourRequest request;
  request.points = some_stops();
  for (const bool open : {false, true}) {
    request.open = open;
    const TourResult tour = plan_tour(planner, request);
    ASSERT_EQ(tour.status, Status::solved);
    const auto length = [&](int a, int b) {
      return planner.plan({.start = request.points[a], .goal = request.points[b]}).length;
    };
    std::vector<double> lengths;
    for (int a = 0; a < 7; ++a)
      for (int b = 0; b < 7; ++b) lengths.push_back(length(a, b));
    const double best = oracle::LeastTour(request, lengths).length();
    EXPECT_NEAR(tour.length, best, 1e-9 * best);
    EXPECT_TRUE(tour.optimal);
    ASSERT_EQ(tour.legs.size(), open ? 6U : 7U);
    for (const TourLeg& leg : tour.legs) {
      EXPECT_EQ(leg.path.front(), request.points[leg.from]);
      EXPECT_EQ(leg.path.back(), request.points[leg.to]);
      EXPECT_NEAR(leg.length, lengths[leg.from * 7 + leg.to], 1e-9 * leg.length);
      EXPECT_EQ(leg.length, path_length(leg.path));
    }
  }
}

TEST(PolygonTours, DoNotDependOnThreadsOrTheUnit) {
  TourRequest request;
  request.threads = 1;
  for (const double unit : {1.0, 1024.0, 0x1p-7}) {
    request.points.clear();
    for (int i = 0; i < 60; ++i)
      for (int j = 0; j < 2; ++j)
        request.points.push_back({unit * (0.5 + 0.3 * i), unit * (1 + 0.05 * i + 15 * j)});
    const Planner planner = rooms(unit);
    const TourResult one = plan_tour(planner, request);
    ASSERT_EQ(one.status, Status::solved);
    ASSERT_TRUE(one.gap());
    EXPECT_LT(*one.gap(), 0.03);
    EXPECT_GE(*one.gap(), 0);
    request.threads = 3;
    EXPECT_EQ(plan_tour(planner, request).order, one.order);
    static std::vector<int> first = one.order;
    EXPECT_EQ(one.order, first) << unit;
  }
}

TEST(PolygonTours, NameWhatTheyLeaveOut) {
  const Planner planner = rooms();
  TourRequest request;
  request.points = some_stops();
  request.points.insert(request.points.end(), {{8, 8}, {37, 17}, {50, 3}});
  const TourResult tour = plan_tour(planner, request);
  EXPECT_EQ(tour.status, Status::solved);
  EXPECT_EQ(tour.order.size(), 7U);
  ASSERT_EQ(tour.left_out.size(), 3U);
  EXPECT_EQ(tour.left_out[0].why, "stop 7 at (8, 8) is blocked");
  EXPECT_EQ(tour.left_out[1].why, "stop 8 at (37, 17) cannot be reached from the others");
  EXPECT_EQ(tour.left_out[2].why, "stop 9 at (50, 3) is outside the map");
  request.start = 8;
  request.goal = 0;
  request.open = true;
  EXPECT_EQ(plan_tour(planner, request).status, Status::unreachable);
  request.start = 7;
  EXPECT_EQ(plan_tour(planner, request).status, Status::invalid);
}

TEST(PolygonTours, GoByGroupsAndRobots) {
  const Planner planner = rooms();
  TourRequest request;
  request.points = some_stops();
  request.group = {-1, 0, 0, 0, -1, -1, -1};
  const TourResult one_of_three = plan_tour(planner, request);
  EXPECT_EQ(one_of_three.order.size(), 5U);
  EXPECT_TRUE(one_of_three.optimal);
  request.group.clear();
  request.robots = {0, 4};
  const TourResult two = plan_tour(planner, request);
  ASSERT_EQ(two.tours.size(), 2U);
  EXPECT_EQ(two.order.size(), 7U);
  EXPECT_TRUE(two.optimal);
}

TEST(PolygonTours, RefuseNonsenseAndStop) {
  const Planner planner = rooms();
  TourRequest request;
  request.points = {{1, 1}, {std::nan(""), 3}};
  EXPECT_THROW(static_cast<void>(plan_tour(planner, request)), Error);
  request.points.assign(2001, {1, 1});
  EXPECT_THROW(static_cast<void>(plan_tour(planner, request)), Error);
  request.points = some_stops();
  request.stop = fired();
  EXPECT_EQ(plan_tour(planner, request).status, Status::interrupted);
}

}  // namespace
}  // namespace lasius::polygon
