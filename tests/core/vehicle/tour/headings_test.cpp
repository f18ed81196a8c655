// What tours of vehicles take of groups and headings, where most have no way; their bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "tests/core/vehicle/tour/least_tour.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

TEST(VehicleTour, TriesAllHeadingsBeforeItLeavesAStopOut) {
  const Planner planner(pocket(), truck());
  TourRequest request;
  request.points = {{10.5, 25.5}, {31.5, 25.5}};
  request.yaws = {0.0, std::nullopt};
  request.start = 0;
  request.open = true;
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.status, Status::solved) << tour.error;
  ASSERT_EQ(tour.order, (std::vector{0, 1}));
  EXPECT_GT(tour.priced, 1);
  const double best =
      least(planner, {{{10.5, 25.5, 0}}, headings(planner, {31.5, 25.5})}, true, true);
  EXPECT_NEAR(tour.length, best, 0.01);
  EXPECT_LT(best, 50);
}

TEST(VehicleTour, BoundsAndTakesAllMembersOfGroups) {
  std::mt19937 random(9);
  const Planner planner(pocket(), truck());
  for (int round = 0; round < 6; ++round) {
    TourRequest request;
    request.points = {{10.5, random_in(8, 42, random) + 0.5},
                      {31.5, 20.5 + 5 * random_in(0, 2, random)},
                      {random_in(44, 56, random) + 0.5, random_in(5, 45, random) + 0.5},
                      {random_in(42, 54, random) + 0.5, random_in(6, 44, random) + 0.5}};
    request.yaws = {random_in(0, 7, random) * std::numbers::pi / 4, std::nullopt, std::nullopt,
                    random_in(0, 7, random) * std::numbers::pi / 4};
    request.group = {-1, 7, 7, -1};
    request.start = 0;
    request.open = round % 2 == 0;
    const TourResult tour = plan_tour(planner, request);
    const auto at = [&](std::size_t i) {
      return Pose{request.points[i].x, request.points[i].y, *request.yaws[i]};
    };
    std::vector<Pose> members = headings(planner, request.points[1]);
    for (const Pose& pose : headings(planner, request.points[2])) members.push_back(pose);
    const double best = least(planner, {{at(0)}, members, {at(3)}}, request.open, true);
    if (best >= 1e9) continue;
    ASSERT_EQ(tour.status, Status::solved) << tour.error;
    EXPECT_TRUE(tour.left_out.empty());
    ASSERT_TRUE(tour.lower_bound);
    EXPECT_LE(*tour.lower_bound, best + 1e-6);
    EXPECT_NEAR(tour.length, best, 0.01);
  }
}

// No way to one member was found from several stops, but from the others there is.
TEST(VehicleTour, BoundIsAtMostToursOverAnyMember) {
  const Planner planner(pocket(), truck());
  TourRequest request;
  request.points = {{31.5, 20.5}, {56.5, 17.5}, {8.5, 39.5}, {14.5, 34.5}, {18.5, 22.5}};
  request.yaws = {std::nullopt, std::nullopt, std::nullopt, std::nullopt, 1.25 * std::numbers::pi};
  request.start = 4;
  request.open = true;
  TourRequest grouped = request;
  grouped.group = {0, 0, -1, -1, -1};
  const TourResult tour = plan_tour(planner, grouped);
  ASSERT_TRUE(tour.lower_bound);
  EXPECT_TRUE(tour.left_out.empty());
  for (const std::ptrdiff_t member : {0, 1}) {
    TourRequest one = request;
    one.points.erase(one.points.begin() + 1 - member);
    one.yaws.erase(one.yaws.begin() + 1 - member);
    one.start = 3;
    const TourResult other = plan_tour(planner, one);
    ASSERT_TRUE(other.status == Status::solved && other.left_out.empty());
    EXPECT_LE(*tour.lower_bound, other.length);
    EXPECT_LE(tour.length, other.length + 0.01);
  }
}

// Along a line legs are as long as their bounds, whatever their digits.
TEST(VehicleTour, BoundHasAllDigits) {
  const Vehicle robot = differential(rectangle(1, 1, 1));
  const Planner planner(Grid(160, 12), robot);
  for (const int count : {4, 14}) {
    TourRequest request;
    request.open = true;
    request.start = 0;
    for (int i = 0; i < count; ++i) {
      request.points.push_back({3 + 10 * std::sqrt(i), 6.0});
      request.yaws.emplace_back(0.0);
    }
    std::swap(request.points[1], request.points[3]);
    const TourResult tour = plan_tour(planner, request);
    ASSERT_TRUE(tour.lower_bound) << tour.error;
    EXPECT_LE(*tour.lower_bound, 10 * std::sqrt(count - 1));
    EXPECT_NEAR(tour.length, 10 * std::sqrt(count - 1), 1e-9);
    EXPECT_NEAR(*tour.lower_bound, tour.length, count <= 12 ? 1e-11 : 1e-5);
    EXPECT_EQ(tour.optimal, count <= 12);
  }
}

TEST(VehicleTour, BoundIsOfTurnsAndOfWalls) {
  Grid grid(60, 40);
  const Vehicle vehicle = car(rectangle(2, 2, 1.25), 3);
  TourRequest request;
  request.open = true;
  request.points = {{10, 5}, {50, 5}};
  request.yaws = {0.0, std::numbers::pi};
  EXPECT_GT(plan_tour(Planner(grid, vehicle), request).lower_bound, 42);
  grid.fill({30, 0, 1, 30}, true);
  EXPECT_GT(plan_tour(Planner(grid, vehicle), request).lower_bound, 64);
}

}  // namespace
}  // namespace lasius::vehicle
