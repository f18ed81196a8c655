// Tours of groups and of several robots, on maps.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "lasius/tour/tour.h"
#include "tests/core/base/refusal.h"
#include "tests/core/tour/rooms.h"
#include "tests/oracle/least_tour.h"

namespace lasius {
namespace {

// Legs lead from stop to stop, robot by robot, and are as long as a plan.
void expect_legs(const Planner& planner, const TourRequest& request, const TourResult& tour) {
  std::size_t leg = 0;
  double sum = 0;
  std::vector<std::vector<int>> orders{tour.order};
  if (!request.robots.empty()) {
    orders.clear();
    ASSERT_EQ(tour.tours.size(), request.robots.size());
    std::vector<int> all;
    for (std::size_t r = 0; r < tour.tours.size(); ++r) {
      const RobotTour& robot = tour.tours[r];
      orders.push_back(robot.order);
      EXPECT_EQ(robot.start, request.robots[r]);
      EXPECT_EQ(robot.order.front(), robot.start);
      EXPECT_EQ(robot.first_leg, static_cast<int>(leg));
      double own = 0;
      for (int i = 0; i < robot.legs; ++i, ++leg) own += tour.legs[leg].length;
      EXPECT_DOUBLE_EQ(robot.length, own);
      all.insert(all.end(), robot.order.begin(), robot.order.end());
    }
    EXPECT_EQ(all, tour.order);
    EXPECT_EQ(leg, tour.legs.size());
    leg = 0;
  }
  for (const auto& order : orders)
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (order.size() == 1 || (request.open && i + 1 == order.size())) break;
      const int to = order[(i + 1) % order.size()];
      ASSERT_LT(leg, tour.legs.size());
      EXPECT_EQ(tour.legs[leg].from, order[i]);
      EXPECT_EQ(tour.legs[leg].to, to);
      const Result planned = planner.plan(
          {.start = request.stops[order[i]], .goal = request.stops[to]}, Params("exact"));
      EXPECT_EQ(tour.legs[leg].length, planned.length);
      sum += planned.length;
      ++leg;
    }
  EXPECT_EQ(leg, tour.legs.size());
  EXPECT_NEAR(tour.length, sum, 1e-9);
}

TEST(RoutedTours, OfGroupsAreShortestOfAllChoices) {
  const Planner planner(rooms());
  const std::vector<int> group = {0, 1, -1, 0, 2, 1, -1, 2, 0};
  const int n = static_cast<int>(group.size());
  for (const int kind : {0, 1, 2, 3, 4}) {
    TourRequest request = ask(some_stops(planner.grid(), n));
    request.group = group;
    request.open = kind > 1;
    if (kind == 1 || kind > 2) request.start = 3;
    if (kind == 4) request.goal = 2;
    request.threads = 1;
    const TourResult tour = plan_tour(planner, request);
    const auto lengths = *planner.distances(request.stops, request.stops, 1);
    EXPECT_EQ(tour.status, Status::solved);
    EXPECT_EQ(tour.order.size(), 5u);
    EXPECT_NEAR(tour.length, oracle::LeastTour(request, lengths).length(), 1e-9) << kind;
    EXPECT_TRUE(tour.optimal);
    EXPECT_TRUE(tour.left_out.empty());
    EXPECT_TRUE(tour.tours.empty());
    expect_legs(planner, request, tour);
  }
}

TEST(RoutedTours, OfRobotsAreShortestOfAllShares) {
  const Planner planner(rooms());
  const int n = 8;
  const TourRequest asked = ask(some_stops(planner.grid(), n));
  const auto lengths = *planner.distances(asked.stops, asked.stops, 1);
  for (const bool open : {false, true})
    for (const int most : {0, 2}) {
      TourRequest request = asked;
      request.open = open;
      request.robots = {5, 0, 2};
      request.most_stops = most;
      request.threads = 1;
      const TourResult tour = plan_tour(planner, request);
      EXPECT_EQ(tour.status, Status::solved);
      EXPECT_NEAR(tour.length, oracle::LeastTour(request, lengths).length(), 1e-9);
      EXPECT_TRUE(tour.optimal);
      expect_legs(planner, request, tour);
    }
}

TEST(RoutedTours, OfManyStopsAreTheSameOnAnyThreads) {
  const Planner planner(rooms());
  for (const bool robots : {false, true}) {
    const int n = 90;
    TourRequest request = ask(some_stops(planner.grid(), n));
    request.generations = 1;
    request.threads = 1;
    for (int i = 0; i < n; ++i) request.group.push_back(i % 4 == 0 ? -1 : i % 25);
    if (robots) request.robots = {0, 40, 8};
    const TourResult tour = plan_tour(planner, request);
    ASSERT_EQ(tour.status, Status::solved);
    std::vector<int> times(25, 0), own;
    for (const int stop : tour.order)
      if (request.group[stop] >= 0)
        ++times[request.group[stop]];
      else
        own.push_back(stop);
    EXPECT_EQ(*std::max_element(times.begin(), times.end()), 1);
    EXPECT_EQ(own.size(), 23u);
    expect_legs(planner, request, tour);
    ASSERT_TRUE(tour.lower_bound);
    EXPECT_LE(*tour.lower_bound, tour.length);
    EXPECT_GT(*tour.lower_bound, 0.4 * tour.length);
    for (const int threads : {2, 5}) {
      request.threads = threads;
      double told = 0;
      const TourResult again = plan_tour(planner, request, [&](auto order, double length) {
        EXPECT_EQ(order.size(), tour.order.size());
        told = length;
      });
      EXPECT_EQ(again.order, tour.order);
      EXPECT_EQ(again.lower_bound, tour.lower_bound);
      EXPECT_NEAR(told, again.length, 0.1);
    }
    request.target_gap = 10;
    EXPECT_GE(plan_tour(planner, request).length, tour.length);
    request.target_gap = 0;
    request.stop.deadline = Clock::time_point::min();
    const TourResult cut = plan_tour(planner, request);
    EXPECT_EQ(cut.status, Status::limit);
    expect_legs(planner, request, cut);
  }
}

TEST(RoutedTours, HaveNoBoundAboveTheOptimumWhenTheTimeIsUp) {
  const Planner planner(rooms());
  for (const int kind : {0, 1, 2, 3}) {
    TourRequest request = ask(some_stops(planner.grid(), 9));
    request.threads = 1;
    if (kind == 3) request.stops.resize(2);  // which leaves no task
    if (kind < 2) request.group = {0, 0, 1, 1, -1, -1, 2, 2, 2};
    if (kind > 0) request.robots = {4, 5};
    if (kind == 3) request.robots = {0, 1};
    const double optimum = plan_tour(planner, request).length;
    request.stop.deadline = Clock::time_point::min();
    const TourResult cut = plan_tour(planner, request);
    EXPECT_EQ(cut.status, Status::limit);
    EXPECT_EQ(cut.optimal, kind == 3);
    EXPECT_LE(cut.lower_bound.value_or(0), optimum + 1e-9) << kind;
  }
}

TEST(RoutedTours, LeaveOutWhatCannotBeDoneAnywhere) {
  Grid grid = rooms();
  for (const Cell c : {Cell{0, 1}, {1, 1}, {1, 0}}) grid.set_blocked(c);
  const Planner planner(grid);
  // A member that is shut in, one that is blocked; a group of none but such; a stop of its own.
  TourRequest request = ask({{0, 0}, {5, 5}, {1, 1}, {0, 0}, {9, 9}, {1, 0}, {20, 5}, {21, 5}});
  request.group = {7, 7, 3, 3, 7, -1, -1, -1};
  const TourResult tour = plan_tour(planner, request);
  EXPECT_EQ(tour.order.size(), 3u);
  ASSERT_EQ(tour.left_out.size(), 2u);
  EXPECT_EQ(tour.left_out[0].stop, 2);
  EXPECT_EQ(tour.left_out[0].group, 3);
  EXPECT_EQ(tour.left_out[0].why, "no stop of group 3 can be visited: stop 2 at (1, 1) is blocked");
  EXPECT_EQ(tour.left_out[1].stop, 5);
  EXPECT_EQ(tour.left_out[1].group, -1);

  request.start = 0;  // then the region is its own
  const TourResult in = plan_tour(planner, request);
  EXPECT_EQ(in.order.front(), 0);
  EXPECT_EQ(in.order.size(), 2u);
  EXPECT_EQ(in.left_out.size(), 3u);

  request = ask({{0, 0}, {5, 5}, {9, 9}});
  request.robots = {1, 0};
  const TourResult apart = plan_tour(planner, request);
  EXPECT_EQ(apart.status, Status::unreachable);
  EXPECT_EQ(apart.error, "stop 0 at (0, 0) cannot be reached from the others");
  request.stops[0] = {1, 1};
  EXPECT_EQ(plan_tour(planner, request).status, Status::invalid);
  request = ask({{3, 3}, {5, 5}, {9, 9}, {8, 8}});
  request.robots = {0};
  request.most_stops = 2;
  const TourResult full = plan_tour(planner, request);
  EXPECT_EQ(full.status, Status::unreachable);
  EXPECT_EQ(full.error, "1 robot has no room for 3 stops, at most 2 each");
}

TEST(RoutedTours, RefuseNonsense) {
  const Planner planner(rooms());
  const auto expect_refused = [&](const std::string& why, const auto& change) {
    TourRequest request = ask(some_stops(planner.grid(), 5));
    change(request);
    expect_says(refusal([&] { plan_tour(planner, request); }), why);
  };
  const std::vector<int> halves = {0, 0, 1, 1, 1};
  expect_refused("group has 2 entries", [](TourRequest& r) { r.group = {0, 0}; });
  const auto halved = [&](bool open, std::optional<int> start, std::optional<int> goal) {
    return [=, &halves](TourRequest& r) {
      r.group = halves;
      r.open = open;
      r.start = start;
      r.goal = goal;
    };
  };
  expect_refused("stops 0 and 1 are both ends of the tour and of group 0", halved(true, 0, 1));
  expect_refused("a closed tour has no goal", halved(false, {}, 1));
  expect_refused("start and goal are the same stop", halved(true, 1, 1));
  expect_refused("tours with groups have no order given in part", [&](TourRequest& r) {
    r.group = halves;
    r.load = {0, 0, 0, 0, 0};
  });
  expect_refused("there is no stop 5 for a robot to begin at",
                 [](TourRequest& r) { r.robots = {5}; });
  expect_refused("two robots begin at stop 1", [](TourRequest& r) { r.robots = {1, 1}; });
  expect_refused("several robots have no other start and no goal", [](TourRequest& r) {
    r.robots = {1};
    r.start = 1;
  });
  expect_refused("the most stops of a robot are given, but no robots",
                 [](TourRequest& r) { r.most_stops = 3; });
  expect_refused("the most stops of a robot are -1", [](TourRequest& r) {
    r.robots = {0, 1};
    r.most_stops = -1;
  });
  expect_refused("ants know no tours with several robots", [](TourRequest& r) {
    r.robots = {0, 1};
    r.ants = tour::AntParams("mmas");
  });
  const Tsplib problem{.size = 2, .matrix = {0, 1, 1, 0}};
  TourRequest request;
  request.robots = {0};
  expect_says(refusal([&] { plan_tour(problem, request); }), "have no groups and no robots");
}

TEST(RoutedTours, GoOverCosts) {
  const Grid grid = rooms();
  const Planner plain(grid);
  CostField field(60, 40);
  field.add(grid, {.radius = 3, .scaling = 0.5});
  const CostPlanner planner(plain, field);
  TourRequest request = ask(some_stops(grid, 9));
  request.group = {0, 0, 1, 1, -1, -1, 2, 2, 2};
  request.robots = {4, 5};
  request.threads = 1;
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.status, Status::solved);
  ASSERT_TRUE(tour.cost && tour.lower_bound);
  EXPECT_LE(*tour.lower_bound, *tour.cost);
  EXPECT_LE(*tour.gap(), 0.01);
  double sum = 0;
  for (const RobotTour& robot : tour.tours) sum += robot.cost;
  EXPECT_NEAR(sum, *tour.cost, 1e-9);
  EXPECT_EQ(tour.order.size(), 5u);

  // Of an order that is found when the time is up already some path is planned for each leg.
  request.stop.deadline = Clock::time_point::min();
  const TourResult cut = plan_tour(planner, request);
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_EQ(cut.priced, 0);
  for (const TourLeg& leg : cut.legs) {
    EXPECT_EQ(leg.path.front(), centre(request.stops[leg.from]));
    EXPECT_EQ(leg.path.back(), centre(request.stops[leg.to]));
    EXPECT_GT(leg.cost, 0);
  }
  EXPECT_GE(*cut.cost, *tour.lower_bound);
}

// A stop where two blocked cells meet is of both regions beside it.
TEST(RoutedTours, VisitStopsWhereBlockedCellsMeet) {
  Grid grid(20, 20);
  for (int i = 0; i < 20; ++i) grid.set_blocked({i, 19 - i});
  const Planner planner(grid);
  for (const bool first : {false, true})
    for (const double other : {3.5, 16.5}) {
      TourRequest request;
      request.points = {{other, other}, {other, other + 1}, {10, 10}};
      if (first)
        std::rotate(request.points.begin(), request.points.begin() + 2, request.points.end());
      const TourResult tour = plan_tour(planner, request);
      EXPECT_EQ(tour.order.size(), 3u) << first << other;
      // It joins nothing: what is on its other side is left out.
      request.points.push_back({20 - other, 20 - other});
      const TourResult parted = plan_tour(planner, request);
      ASSERT_EQ(parted.left_out.size(), 1u);
      EXPECT_EQ(parted.left_out[0].stop, 3);
    }
}

}  // namespace
}  // namespace lasius
