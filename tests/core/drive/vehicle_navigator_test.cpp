// What is left of a vehicle's way, step by step: kept, led back to, planned anew, doubted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/drive/kept_way.h"
#include "lasius/base/error.h"
#include "lasius/vehicle/navigator.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/oracle/vehicle/motions.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

const std::vector<Point> kBox = rectangle(2, 5, 2);

/// Two rooms and a door in the wall between them, 12 cells wide.
Grid two_rooms() {
  Grid grid = walled(100, 60, {{50, 0, 2, 60}});
  grid.fill({50, 10, 2, 12}, false);
  return grid;
}

void expect_clear(const Grid& grid, const Vehicle& vehicle, const Way& way) {
  oracle::FootprintJudge judge(grid, vehicle.footprint);
  EXPECT_FALSE(judge.first_touch(oracle::motions_of(way.segments)));
}

void expect_from(const Pose& pose, const Way& way) {
  ASSERT_FALSE(way.segments.empty());
  const Pose& begin = way.segments[0].begin;
  EXPECT_NEAR(begin.x, pose.x, 1e-6);
  EXPECT_NEAR(begin.y, pose.y, 1e-6);
  EXPECT_NEAR(std::remainder(begin.yaw - pose.yaw, 2 * std::numbers::pi), 0, 1e-6);
}

TEST(VehicleNavigator, GoesTheCheapestWayOverItsCosts) {
  const Grid grid(100, 60);
  const Vehicle vehicle = car(kBox, 5);
  const auto band = [&](double weight) {  // across the straight way, up to 30 cells beside it
    std::vector<double> weights(6000, 1);
    for (int y = 0; y < 50; ++y)
      for (int x = 40; x < 60; ++x) weights[static_cast<std::size_t>(y) * 100 + x] = weight;
    return CostField(100, 60, weights);
  };
  Navigator navigator(grid, vehicle, {{90, 20, 0}});
  const Pose from{10, 20, 0};
  const double straight = navigator.step(from).length;
  EXPECT_NEAR(straight, 80, 1e-6);
  // A little dearer: still the straight way, kept, its cost by the weights.
  navigator.set_costs(band(1.25));
  Way way = navigator.step(from);
  EXPECT_FALSE(way.replanned);
  EXPECT_NEAR(way.cost, 60 + 20 * 1.25, 1e-6);
  // Much dearer: around it, as a Planner finds that.
  navigator.set_costs(band(9));
  way = navigator.step(from);
  EXPECT_TRUE(way.replanned);
  EXPECT_GT(way.length, straight + 1);
  EXPECT_LT(way.cost, 60 + 20 * 9);
  const Planner planner(grid, vehicle, band(9));
  EXPECT_EQ(way.segments, planner.plan({.start = from, .goals = {{90, 20, 0}}}).segments);
  EXPECT_EQ(way.cost, planner.cost(way.segments));
  EXPECT_NEAR(navigator.cost(std::vector<Segment>{{.begin = from, .length = 80}}), 60 + 20 * 9,
              1e-6);
  EXPECT_EQ(Navigator(grid, vehicle, {{90, 20, 0}}, {.costs = band(9)}).step(from).segments,
            way.segments);
  // Kept over walls beside it; straight again without the band.
  navigator.observe(Rectangle{1, 1, 1, 1}, true);
  const Pose on = way.segments[0].pose(way.segments[0].extent() / 2);
  const Way left = navigator.step(on);
  EXPECT_FALSE(left.replanned);
  EXPECT_TRUE(left.over_costs);
  EXPECT_LT(left.cost, way.cost);
  EXPECT_NEAR(left.cost, planner.cost(left.segments), 1e-9);
  navigator.set_costs(band(1));
  EXPECT_NEAR(navigator.step(from).length, straight, 1e-6);
  EXPECT_THROW(navigator.set_costs(CostField(100, 61)), Error);
  EXPECT_THROW(Navigator(grid, vehicle, {from}, {.costs = CostField(60, 100)}), Error);
  // No step meets weights that inflation makes too great.
  const Inflation heavy{.radius = 8, .scaling = 0.5, .weight = CostField::kMost - 5};
  EXPECT_THROW(Navigator(grid, vehicle, {from}, {.costs = band(6), .inflation = heavy}), Error);
  Navigator inflated(grid, vehicle, {from}, {.inflation = heavy});
  EXPECT_THROW(inflated.set_costs(band(6)), Error);
  EXPECT_NO_THROW(inflated.set_costs(band(5)));
}

TEST(VehicleNavigator, KeepsTheRestOfItsWay) {
  const Grid grid = two_rooms();
  Vehicle priced = car(kBox, 5);
  priced.cusp_cost = 3;
  Vehicle steady = car(kBox, 5);
  steady.curvature_rate = 0.05;
  for (const Vehicle& vehicle : {car(kBox, 5), priced, steady, differential(kBox), omni(kBox)}) {
    Navigator navigator(grid, vehicle, {{90, 50, 2}});
    Way way = navigator.step({10, 50, 0});
    ASSERT_EQ(way.status, Status::solved) << way.error;
    EXPECT_TRUE(way.replanned);
    const std::vector<Segment> plan = way.segments;
    // Every pose of the plan, in its order, cusps and turns included.
    double driven = 0;
    std::size_t last = 0;
    for (const PathPose& at : poses(plan, 0.7)) {
      if (at.segment > static_cast<int>(last)) driven += plan[last++].length;
      way = navigator.step(at.pose);
      ASSERT_FALSE(way.replanned);
      expect_from(at.pose, way);
      const double before = driven + (at.gear == 0 ? 0 : at.at);
      ASSERT_NEAR(way.length, driven_length(plan) - before, 1e-6);
      ASSERT_EQ(way.goal, 0);
    }
    EXPECT_EQ(way.length, 0);
  }
}

// What is left of a clothoid goes on with the curvature that it has there.
TEST(VehicleNavigator, OfSteadyCurvaturePlansAnewBesideItsWay) {
  Vehicle steady = car(kBox, 5);
  steady.curvature_rate = 0.05;
  Navigator navigator(two_rooms(), steady, {{90, 50, 2}});
  const std::vector<Segment> plan = navigator.step({10, 50, 0}).segments;
  const auto bent = std::ranges::find_if(plan, [](const auto& s) { return s.curvature_rate != 0; });
  ASSERT_NE(bent, plan.end());
  const Segment rest = rest_of(*bent, bent->length / 3);
  for (const double share : {0.0, 0.3, 1.0}) {
    const Pose a = bent->pose(bent->length / 3 + share * rest.length),
               b = rest.pose(share * rest.length);
    EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y) + std::fabs(a.yaw - b.yaw), 0, 1e-9);
  }
  const Pose on = rest.begin;
  EXPECT_FALSE(navigator.step(on).replanned);
  const Way beside = navigator.step({on.x, on.y + 0.1, on.yaw});
  EXPECT_TRUE(beside.replanned);
  EXPECT_EQ(beside.rejoined, 0);
  expect_from({on.x, on.y + 0.1, on.yaw}, beside);
}

// The inflation of a wall that the way does not meet makes another one cheaper; without the wall
// the first is again.
TEST(VehicleNavigator, InflationFollowsWhatIsSeen) {
  const Vehicle vehicle = car(kBox, 5);
  const Inflation inflation{.radius = 12, .scaling = 0.1, .weight = 5, .inscribed = 2};
  const Pose start{10, 30, 0}, goal{110, 30, 0};
  Grid grid(120, 60);
  Navigator navigator(grid, vehicle, {goal}, {.inflation = inflation});
  const Way first = navigator.step(start);
  EXPECT_NEAR(first.cost, 100, 1e-6);
  const Rectangle post{55, 24, 6, 3};
  navigator.observe(post, true);
  grid.fill(post, true);
  const Way aside = navigator.step(start);
  EXPECT_TRUE(aside.replanned);
  expect_clear(grid, vehicle, aside);
  EXPECT_LT(aside.cost, 0.9 * navigator.cost(first.segments));
  CostField costs(120, 60);
  costs.add(grid, inflation);
  EXPECT_NEAR(aside.cost, Planner(grid, vehicle, costs).cost(aside.segments), 1e-9);
  navigator.observe(post, false);
  EXPECT_NEAR(navigator.step(start).cost, 100, 1e-6);
}

TEST(VehicleNavigator, PlansAnewWhereAWallIsMetAndOnlyThere) {
  const Grid grid = two_rooms();
  const Vehicle vehicle = car(kBox, 5);
  Navigator navigator(grid, vehicle, {{90, 15, 0}});
  const Pose start{10, 16, 0};
  const Way first = navigator.step(start);
  ASSERT_EQ(first.status, Status::solved);
  // Beside the way, far from the sweep.
  navigator.observe(Rectangle{20, 40, 5, 5}, true);
  EXPECT_FALSE(navigator.step(start).replanned);
  // A cell that the sweep meets at its edge, judged by the oracle.
  Grid with = navigator.map();
  Cell post{};
  for (post = {30, 5}; post.y < 30; ++post.y) {
    Grid one(100, 60);
    one.set_blocked(post);
    oracle::FootprintJudge judge(one, vehicle.footprint);
    if (judge.first_touch(oracle::motions_of(first.segments))) break;
    navigator.observe(std::vector<Cell>{post}, true);
    with.set_blocked(post);
    const bool replanned = navigator.step(start).replanned;
    // It may come nearer than what is certified.
    if (replanned) break;
  }
  ASSERT_LT(post.y, 30);
  navigator.observe(std::vector<Cell>{post}, true);
  with.set_blocked(post);
  const Way second = navigator.step(start);
  ASSERT_EQ(second.status, Status::solved);
  expect_clear(with, vehicle, second);
}

// Walls near every place of a way are found by the look at the cells alone as by the oracle.
TEST(VehicleNavigator, MeetsWhatTheOracleMeets) {
  std::mt19937 random(5);
  const Vehicle vehicle = car(kBox, 5);
  const Grid empty(100, 60);
  const Planner planner(empty, vehicle);
  const Result plan = planner.plan({.start = {20, 20, 1}, .goals = {{60, 40, 4}}});
  ASSERT_EQ(plan.status, Status::solved);
  const auto motions = oracle::motions_of(plan.segments);
  int met = 0, more = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<Cell> cells;
    Grid grid(100, 60);
    for (int k = 0; k < 2; ++k) {
      const Cell c{random_in(10, 70, random), random_in(10, 50, random)};
      cells.push_back(c);
      grid.set_blocked(c);
    }
    oracle::FootprintJudge judge(grid, vehicle.footprint);
    const bool touches = judge.first_touch(motions).has_value();
    const bool told = meets(vehicle, plan.segments, cells);
    ASSERT_TRUE(told || !touches);
    met += touches;
    more += told && !touches;
  }
  EXPECT_GT(met, 60);
  EXPECT_LE(more, 2);
}

TEST(VehicleNavigator, LeadsBackFromBesideItsWay) {
  const Grid grid = two_rooms();
  for (const Vehicle& vehicle : {car(kBox, 5), differential(kBox), omni(kBox)}) {
    Navigator navigator(grid, vehicle, {{90, 50, 0}});
    const Way plan = navigator.step({10, 50, 0});
    ASSERT_EQ(plan.status, Status::solved);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-0.2, 0.2);
    int back = 0, steps = 0;
    for (const PathPose& at : poses(plan.segments, 4)) {
      const Pose robot{at.pose.x + noise(random), at.pose.y + noise(random),
                       at.pose.yaw + noise(random) / 4};
      const Way way = navigator.step(robot);
      ASSERT_EQ(way.status, Status::solved) << way.error;
      expect_from(robot, way);
      if (way.way_out == 0) expect_clear(grid, vehicle, way);
      back += !way.replanned && way.rejoined > 0;
      ++steps;
    }
    EXPECT_GE(back, steps * 3 / 4);
  }
}

TEST(VehicleNavigator, AWallThatHasGoneMayShortenTheWay) {
  const Grid grid = two_rooms();
  const Vehicle vehicle = car(kBox, 5);
  Navigator navigator(grid, vehicle, {{90, 50, 0}});
  const Pose start{10, 50, 0};
  const double length = navigator.step(start).length;
  navigator.observe(Rectangle{50, 0, 2, 1}, false);  // no gain there
  EXPECT_FALSE(navigator.step(start).replanned);
  navigator.observe(Rectangle{50, 44, 2, 12}, false);
  const Way way = navigator.step(start);
  EXPECT_TRUE(way.replanned);
  EXPECT_LT(way.length, length - 5);
}

TEST(VehicleNavigator, AStoppedStepForgetsNoShorterWay) {
  const Vehicle vehicle = car(kBox, 5);
  Navigator navigator(two_rooms(), vehicle, {{90, 50, 0}});
  const Pose start{10, 50, 0};
  const double length = navigator.step(start).length;
  navigator.observe(Rectangle{50, 44, 2, 12}, false);
  for (int i = 0; i < 2; ++i) {
    const Way way = navigator.step(start, fired());
    EXPECT_EQ(way.status, Status::solved);
    EXPECT_EQ(way.length, length);
  }
  EXPECT_LT(navigator.step(start).length, length - 5);
  EXPECT_FALSE(navigator.step(start).replanned);
}

TEST(VehicleNavigator, WithinTheTolerancesItIsThere) {
  const Pose goal{90, 50, 0};
  for (const Vehicle& vehicle : {car(kBox, 5), omni(kBox)}) {
    Navigator navigator(two_rooms(), vehicle, {{10, 10, 0}, goal},
                        {.goal_tolerance = 1, .heading_tolerance = 0.2});
    const Way plan = navigator.step({70, 50, 0});
    ASSERT_EQ(plan.goal, 1);
    const Pose end = plan.segments.back().end();
    for (const double on : {0.0, 0.3, 0.6}) {
      const Pose robot{end.x + on * (goal.x - end.x), end.y + on * (goal.y - end.y), 0.15};
      const Way way = navigator.step(robot);
      EXPECT_EQ(way.status, Status::solved);
      EXPECT_EQ(way.length, 0);
      EXPECT_EQ(way.goal, 1);
      ASSERT_EQ(way.segments.size(), 1U);
      EXPECT_EQ(way.segments[0].begin, robot);
    }
    // Turned too far, or too far away.
    EXPECT_GT(navigator.step({goal.x, goal.y, 0.3}).cost, 0);
    EXPECT_GT(navigator.step({goal.x - 1.2, goal.y, 0}).length, 0);
  }
}

TEST(VehicleNavigator, AStoppedWayOutIsNoProof) {
  const Grid grid = walled(60, 60, {{30, 0, 30, 20}});
  const Pose robot{26.5, 10, 0};
  Navigator navigator(grid, car(kBox, 5), {{10, 50, 2}});
  const Way stopped = navigator.step(robot, fired());
  EXPECT_EQ(stopped.status, Status::interrupted);
  EXPECT_EQ(stopped.fault, Fault::none);
  EXPECT_FALSE(stopped.error.empty());
  const Way late = navigator.step(robot, {.deadline = Clock::time_point::min()});
  EXPECT_EQ(late.status, Status::limit);
  EXPECT_EQ(navigator.step(robot).way_out, 1);
}

TEST(VehicleNavigator, LeadsOutOfItsOwnMargin) {
  const Grid grid = walled(60, 60, {{30, 0, 30, 20}});
  Vehicle turning = differential(kBox);
  turning.reverse = true;
  for (const Vehicle& vehicle : {car(kBox, 5), turning, omni(kBox)}) {
    Navigator navigator(grid, vehicle, {{10, 50, 2}});
    const Pose robot{26.5, 10, 0};  // its nose is 1.5 cells in the wall
    const auto way_from = [&](const Pose& pose) { return navigator.step(pose); };
    const Way way = way_from(robot);
    ASSERT_EQ(way.status, Status::solved) << way.error;
    ASSERT_EQ(way.way_out, 1);
    expect_from(robot, way);
    // Over the way out it meets only what it meets where it stands; then nothing.
    Grid others = grid;
    for (const Cell c : met_cells(vehicle, robot)) {
      if (others.contains(c)) others.set_blocked(c, false);
    }
    const auto motions = oracle::motions_of(way.segments);
    oracle::FootprintJudge out(others, vehicle.footprint), then(grid, vehicle.footprint);
    EXPECT_FALSE(out.first_touch(std::span(motions).first(1)));
    EXPECT_FALSE(then.first_touch(std::span(motions).subspan(1)));
    EXPECT_LT(way.segments[0].extent(), 4);
    // Halfway out it is still on it.
    const Way rest = way_from(way.segments[0].pose(way.segments[0].extent() / 2));
    EXPECT_FALSE(rest.replanned);
    EXPECT_EQ(rest.way_out, 1);
    EXPECT_EQ(way_from(way.segments[1].pose(0.1)).way_out, 0);
  }
}

TEST(VehicleNavigator, DoubtsWallsThatItDidNotSeeAgain) {
  const Vehicle vehicle = car(kBox, 5);
  Navigator navigator(two_rooms(), vehicle, {{90, 50, 0}}, {.doubt_after = 3});
  const Pose start{10, 50, 0};
  navigator.observe(Rectangle{50, 10, 2, 12}, true);  // the door
  for (int i = 0; i < 3; ++i) {
    const Way way = navigator.step(start);
    EXPECT_EQ(way.status, Status::unreachable);
    EXPECT_EQ(way.doubted, 0);
  }
  const Way way = navigator.step(start);
  EXPECT_EQ(way.status, Status::solved);
  EXPECT_EQ(way.doubted, 24);
  EXPECT_EQ(navigator.map(), two_rooms());
}

TEST(VehicleNavigator, OtherGoalsAndBadInput) {
  const Vehicle vehicle = car(kBox, 5);
  EXPECT_THROW(Navigator(two_rooms(), vehicle, {}), Error);
  EXPECT_THROW(Navigator(two_rooms(), {}, {{1, 1, 1}}), Error);
  Navigator navigator(two_rooms(), vehicle, {{90, 50, 0}, {30, 40, 0}});
  EXPECT_EQ(navigator.step({10, 50, 0}).goal, 1);
  for (const Pose& bad : {Pose{std::nan(""), 1, 1}, Pose{1, 1, 1e9}})
    EXPECT_THROW((void)navigator.step(bad), Error);
  navigator.set_goals({{51, 40, 0}});
  const Way way = navigator.step({10, 50, 0});
  EXPECT_EQ(way.status, Status::invalid);
  EXPECT_EQ(way.fault, Fault::goal_blocked);
  EXPECT_THROW(navigator.set_goals({}), Error);
  navigator.observe(Rectangle{-5, -5, 3, 3}, true);  // outside
  EXPECT_EQ(navigator.map(), two_rooms());
}

}  // namespace
}  // namespace lasius::vehicle
