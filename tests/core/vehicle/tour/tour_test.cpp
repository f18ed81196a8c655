// Tours of vehicles: legs that join, that the oracle sees touch nothing; orders against all orders
// over the plans of all pairs.
#include "lasius/vehicle/tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "lasius/base/error.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/vehicle/tour/least_tour.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/oracle/vehicle/motions.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

using oracle::FootprintJudge;

/// Free poses at whole yaws.
TourRequest poses_on(const Grid& grid, const Planner& planner, int count, std::mt19937& random) {
  TourRequest request;
  while (static_cast<int>(request.points.size()) < count) {
    const int x = random_in(0, grid.width() - 1, random);
    const int y = random_in(0, grid.height() - 1, random);
    const Pose pose{x + 0.5, y + 0.5, 1.0 * random_in(0, 6, random)};
    if (!planner.space().free(pose)) continue;
    request.points.push_back({pose.x, pose.y});
    request.yaws.emplace_back(pose.yaw);
  }
  return request;
}

double turned(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// Poses, joints, contacts, sums.
void judge(const Grid& grid, const Vehicle& vehicle, const TourRequest& request,
           const TourResult& tour) {
  ASSERT_EQ(tour.poses.size(), tour.order.size());
  ASSERT_EQ(tour.plans.size(), tour.legs.size());
  FootprintJudge judged(grid, vehicle.footprint);
  std::map<int, Pose> at;
  for (std::size_t i = 0; i < tour.order.size(); ++i) {
    const int stop = tour.order[i];
    const Pose& pose = at[stop] = tour.poses[i];
    EXPECT_EQ((Point{pose.x, pose.y}), request.points[stop]);
    if (!request.yaws.empty() && request.yaws[stop]) {
      EXPECT_EQ(pose.yaw, *request.yaws[stop]);
    }
  }
  double length = 0;
  for (std::size_t i = 0; i < tour.legs.size(); ++i) {
    const Result& plan = tour.plans[i];
    const Pose from = at.at(tour.legs[i].from), to = at.at(tour.legs[i].to);
    const Pose begin = plan.segments.front().begin, end = plan.segments.back().end();
    EXPECT_EQ((Point{begin.x, begin.y}), (Point{from.x, from.y}));
    EXPECT_LE(turned(begin.yaw, from.yaw), 1e-9);
    EXPECT_LE(std::hypot(end.x - to.x, end.y - to.y) + turned(end.yaw, to.yaw), 1e-6);
    EXPECT_FALSE(judged.first_touch(oracle::motions_of(plan.segments)));
    EXPECT_EQ(tour.legs[i].path.front(), (Point{from.x, from.y}));
    EXPECT_LE(plan.lower_bound, plan.length);
    length += plan.length;
  }
  EXPECT_DOUBLE_EQ(tour.length, length);
  ASSERT_TRUE(tour.lower_bound);
  EXPECT_LE(*tour.lower_bound, tour.length);
}

TEST(VehicleTour, IsShortestOverThePlansOfAllPairs) {
  std::mt19937 random(5);
  int whole = 0;
  for (const Vehicle& vehicle :
       {car(rectangle(2, 2, 1.25), 3), truck(), differential(rectangle(2, 2, 1.25))})
    for (const bool open : {false, true}) {
      const Grid grid = random_blocks(60, 50, 10, 7, random);
      const Planner planner(grid, vehicle);
      TourRequest request = poses_on(grid, planner, 6, random);
      request.open = open;
      const TourResult tour = plan_tour(planner, request);
      std::vector<Pose> all;
      for (std::size_t i = 0; i < request.points.size(); ++i)
        all.push_back({request.points[i].x, request.points[i].y, *request.yaws[i]});
      for (const LeftOut& out : tour.left_out) {  // no way there, or none away
        const auto joins = [&](const Pose& from, const Pose& to) {
          return planner.plan({.start = from, .goals = {to}}).goal >= 0;
        };
        const Pose& at = all[static_cast<std::size_t>(out.stop)];
        const auto others = [&](const auto& any) {
          return std::ranges::count_if(all, [&](const Pose& p) { return !(p == at) && any(p); });
        };
        EXPECT_TRUE(others([&](const Pose& p) { return joins(p, at); }) == 0 ||
                    others([&](const Pose& p) { return joins(at, p); }) == 0);
      }
      if (!tour.left_out.empty()) continue;
      ++whole;
      ASSERT_EQ(tour.status, Status::solved) << tour.error;
      judge(grid, vehicle, request, tour);
      std::vector<std::vector<Pose>> stops;
      for (const Pose& pose : all) stops.push_back({pose});
      EXPECT_NEAR(tour.length, least(planner, stops, open), 0.01);
      for (const int threads : {1, 2, 5}) {
        request.threads = threads;
        const TourResult again = plan_tour(planner, request);
        EXPECT_EQ(again.order, tour.order);
        EXPECT_EQ(again.length, tour.length);
        EXPECT_EQ(again.lower_bound, tour.lower_bound);
        EXPECT_EQ(again.priced, tour.priced);
      }
    }
  EXPECT_GE(whole, 4);
}

TEST(VehicleTour, ChoosesHeadingsAmongEight) {
  std::mt19937 random(6);
  const Grid grid = random_blocks(40, 30, 4, 7, random);
  const Vehicle vehicle = truck();
  const Planner planner(grid, vehicle);
  TourRequest request = poses_on(grid, planner, 3, random);
  std::vector<std::vector<Pose>> stops;
  for (std::size_t i = 0; i < request.points.size(); ++i) {
    const Point p = request.points[i];
    stops.emplace_back();
    if (i == 0) stops[i].push_back({p.x, p.y, *request.yaws[i]});
    if (i > 0) stops[i] = headings(planner, p);
  }
  request.yaws[1].reset();
  request.yaws[2].reset();
  request.start = 0;
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.status, Status::solved) << tour.error;
  judge(grid, vehicle, request, tour);
  EXPECT_EQ(tour.order.front(), 0);
  EXPECT_NEAR(tour.length, least(planner, stops, false), 0.01);
  EXPECT_LT(tour.priced, 100);  // of 144 pairs
}

TEST(VehicleTour, OfRobotsAndOfManyStops) {
  std::mt19937 random(7);
  const Grid grid = random_blocks(80, 60, 12, 7, random);
  const Vehicle vehicle = car(rectangle(2, 2, 1.25), 3);
  const Planner planner(grid, vehicle);
  TourRequest request = poses_on(grid, planner, 15, random);
  request.generations = 5;
  const TourResult one = plan_tour(planner, request);
  ASSERT_EQ(one.status, Status::solved) << one.error;
  judge(grid, vehicle, request, one);
  EXPECT_EQ(one.order.size() + one.left_out.size(), 15U);
  TourRequest two = request;
  two.points.resize(6);
  two.yaws.resize(6);
  two.robots = {0, 1};
  two.most_stops = 2;
  const TourResult shared = plan_tour(planner, two);
  ASSERT_EQ(shared.status, Status::solved) << shared.error;
  judge(grid, vehicle, two, shared);
  ASSERT_EQ(shared.tours.size(), 2U);
  for (const RobotTour& robot : shared.tours) EXPECT_EQ(robot.order.size(), 3U);
}

TEST(VehicleTour, OverCostsIsOfTheCost) {
  std::mt19937 random(8);
  const Grid grid(40, 30);
  std::vector<double> weights(40 * 30, 1);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = i % 40 < 20 ? 1 : 3;
  const Vehicle vehicle = car(rectangle(2, 2, 1.25), 3);
  const Planner planner(grid, vehicle, CostField(40, 30, weights));
  const TourResult tour = plan_tour(planner, poses_on(grid, planner, 5, random));
  ASSERT_EQ(tour.status, Status::solved) << tour.error;
  ASSERT_TRUE(tour.cost && tour.lower_bound);
  double cost = 0;
  for (const Result& plan : tour.plans) cost += plan.cost;
  EXPECT_DOUBLE_EQ(*tour.cost, cost);
  EXPECT_LE(*tour.lower_bound, *tour.cost);
  EXPECT_GT(*tour.lower_bound, 0);
  TourRequest one = poses_on(grid, planner, 1, random);
  const TourResult alone = plan_tour(planner, one);
  EXPECT_EQ(alone.status, Status::solved);
  EXPECT_EQ(alone.cost, 0.0);
}

TEST(VehicleTour, NamesWhatItLeavesOut) {
  Grid grid(60, 40);
  grid.fill({40, 0, 1, 20}, true);  // a room of its own
  grid.fill({40, 20, 20, 1}, true);
  grid.fill({0, 30, 10, 1}, true);  // an end that is dead for what cannot reverse
  grid.fill({0, 34, 10, 1}, true);
  const Planner planner(grid, truck());
  TourRequest request;
  request.points = {{20, 10}, {50, 10}, {40.5, 5}, {5, 32.5}, {30, 30}, {-4, 3}, {15, 20}};
  request.yaws = {0.0, 0.0, std::nullopt, std::numbers::pi, std::nullopt, 0.0, 0.0};
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.status, Status::solved) << tour.error;
  judge(grid, truck(), request, tour);
  ASSERT_EQ(tour.left_out.size(), 4U);
  const auto why = [&](std::size_t i) { return tour.left_out[i].why; };
  EXPECT_EQ(why(0), "stop 1 at (50, 10) cannot be reached from the others");
  EXPECT_EQ(why(1), "stop 2 at (40.5, 5) is blocked");
  EXPECT_EQ(why(2), "stop 3 at (5, 32.5): no way was found between it and the others");
  EXPECT_EQ(why(3), "stop 5 at (-4, 3) is outside the map");
  TourRequest grouped = request;
  grouped.group = {-1, -1, -1, 4, -1, 4, -1};
  const TourResult lost = plan_tour(planner, grouped);
  ASSERT_EQ(lost.left_out.size(), 3U);
  EXPECT_EQ(lost.left_out[2].stop, 3);
  EXPECT_EQ(lost.left_out[2].group, 4);
  EXPECT_EQ(lost.left_out[2].why, "no stop of group 4 can be visited: " + why(2));
  grouped.group = {-1, -1, -1, 4, 4, -1, -1};  // the other one is visited
  const TourResult kept = plan_tour(planner, grouped);
  ASSERT_EQ(kept.left_out.size(), 3U);
  EXPECT_EQ(kept.left_out[2].stop, 5);
  request.start = 3;
  const TourResult none = plan_tour(planner, request);
  EXPECT_EQ(none.status, Status::no_path);
  EXPECT_EQ(none.error, why(2));
  EXPECT_TRUE(none.order.empty());
}

// Of two ends that are dead for what cannot reverse one can be left alone, one be reached alone.
TEST(VehicleTour, BeginsWhereNothingLeads) {
  Grid grid(60, 40);
  for (const int y : {10, 14, 30, 34}) grid.fill({0, y, 10, 1}, true);
  const Planner planner(grid, truck());
  TourRequest request;
  request.points = {{20, 10}, {5, 32.5}, {30, 30}, {5, 12.5}, {50, 10}};
  request.yaws = {0.0, std::numbers::pi, std::nullopt, 0.0, 0.0};
  request.open = true;
  request.goal = 4;
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.left_out.size(), 1U);
  EXPECT_EQ(tour.left_out[0].stop, 1);
  EXPECT_EQ(tour.order.front(), 3);
}

// Two poses that touch a cell to within rounding: no motion from there is certified.
TEST(VehicleTour, LeavesOutTheTrappedWhateverTheSeed) {
  Grid grid(60, 40);
  TourRequest request;
  for (const auto& cell : {Cell{11, 30}, Cell{31, 20}}) {
    grid.set_blocked(cell, true);
    request.points.push_back({cell.x - 0.5, cell.y + 1.5});
    request.yaws.emplace_back(1.57);
  }
  for (int i = 0; i < 12; ++i) {
    request.points.push_back({5.5 + 4 * i, 5.5 + 3 * (i * 5 % 7)});
    request.yaws.emplace_back(1.0 * (i % 6));
  }
  const Vehicle vehicle = differential(rectangle(0.5, 2, 0.5));
  const Planner planner(grid, vehicle);
  request.generations = 1;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    request.seed = seed;
    request.open = seed != 6;  // the same ones stay
    if (seed == 5) request.generations = 20;
    const TourResult tour = plan_tour(planner, request);
    ASSERT_EQ(tour.status, Status::solved) << tour.error;
    ASSERT_EQ(tour.left_out.size(), 2U);
    EXPECT_EQ(tour.left_out[0].stop, 0);
    EXPECT_EQ(tour.left_out[1].stop, 1);
    judge(grid, vehicle, request, tour);
  }
}

// Without obstacles legs are as long as their bounds: the first order that is looked for to the end
// is the last. When time is up at once another one has to do.
TEST(VehicleTour, TimeEndsTheFirstOrderToo) {
  const Grid grid(200, 160);
  const Planner planner(grid, truck());
  std::mt19937 random(3);
  for (const int stops : {11, 16}) {
    TourRequest request = poses_on(grid, planner, stops, random);
    const TourResult whole = plan_tour(planner, request);
    ASSERT_EQ(whole.status, Status::solved);
    const CountingTime time(0);
    request.stop = time.is_up();
    const TourResult late = plan_tour(planner, request);
    EXPECT_EQ(late.status, Status::limit);
    EXPECT_EQ(late.order.size(), request.points.size());
    EXPECT_GT(late.length, whole.length + 1);
    judge(grid, truck(), request, late);
  }
}

// Whenever a signal comes, the order at hand gets its legs.
// Judges the tours that a signal cuts at ever later looks at the clock, until one is whole or
// `most` are passed; how many there were.
template <class Judge>
int tours_cut(const Planner& planner, TourRequest request, int most, const Judge& judge_cut) {
  int interrupted = 0;
  for (int looks = 0; looks < most; looks = 2 * looks + 1) {
    const FiringTime time(looks);
    request.stop = time.fires();
    const TourResult tour = plan_tour(planner, request);
    if (tour.status == Status::solved) break;
    ++interrupted;
    EXPECT_EQ(tour.status, Status::interrupted);
    judge_cut(tour, looks);
  }
  return interrupted;
}

TEST(VehicleTour, ASignalLeavesATour) {
  const Grid grid(200, 160);
  const Planner planner(grid, truck());
  std::mt19937 random(5);
  for (const int stops : {5, 14}) {
    const TourRequest request = poses_on(grid, planner, stops, random);
    const int interrupted =
        tours_cut(planner, request, 1 << 12, [&](const TourResult& tour, int looks) {
          ASSERT_EQ(tour.order.size(), request.points.size()) << looks;
          judge(grid, truck(), request, tour);
        });
    EXPECT_GT(interrupted, 2);
  }
}

// Also where each order of all stops has a leg without a way: into an end and out of it again.
TEST(VehicleTour, ASignalLeavesATourOfWhatIsJoined) {
  Grid grid(60, 40);
  grid.fill({0, 30, 10, 1}, true);
  grid.fill({0, 34, 10, 1}, true);
  const Planner planner(grid, truck());
  TourRequest request;
  request.points = {{20, 10}, {5, 32.5}, {30, 30}, {15, 20}, {50, 10}};
  request.yaws = {0.0, std::numbers::pi, std::nullopt, 0.0, 0.0};
  const int interrupted =
      tours_cut(planner, request, 1 << 16, [&](const TourResult& tour, int looks) {
        ASSERT_EQ(tour.order.size(), request.points.size() - 1) << looks;
        ASSERT_EQ(tour.left_out.size(), 1U);
        EXPECT_EQ(tour.left_out[0].stop, 1);
        judge(grid, truck(), request, tour);
      });
  EXPECT_GT(interrupted, 2);
}

TEST(VehicleTour, RefusesAndStops) {
  const Grid grid(60, 40);
  const Planner planner(grid, truck());
  TourRequest request;
  request.points = {{20, 10}, {50, 10}, {30, 30}};
  EXPECT_EQ(plan_tour(planner, request).status, Status::solved);
  request.start = 0;
  EXPECT_THROW((void)plan_tour(planner, request), Error);  // no yaw
  request.yaws = {0.0};
  EXPECT_THROW((void)plan_tour(planner, request), Error);
  request.yaws = {0.0, std::nan(""), std::nullopt};
  EXPECT_THROW((void)plan_tour(planner, request), Error);
  request.yaws = {0.0, 1.0, std::nullopt};
  request.goal = 1;
  EXPECT_THROW((void)plan_tour(planner, request), Error);  // it is closed
  request.open = true;
  request.goal = 0;
  EXPECT_THROW((void)plan_tour(planner, request), Error);  // the start
  request.open = false;
  request.goal.reset();
  request.after = {{}, {2}, {}};
  EXPECT_THROW((void)plan_tour(planner, request), Error);
  request.after.clear();
  request.stop.deadline = Clock::now();
  const TourResult late = plan_tour(planner, request);
  EXPECT_EQ(late.status, Status::limit);
  judge(grid, truck(), request, late);
  TourRequest late_pocket;  // whose first legs have no plans
  late_pocket.points = {{10.5, 25.5}, {31.5, 25.5}};
  late_pocket.yaws = {0.0, std::nullopt};
  late_pocket.stop.deadline = Clock::now();
  late_pocket.start = 0;
  late_pocket.open = true;
  const TourResult found = plan_tour(Planner(pocket(), truck()), late_pocket);
  EXPECT_EQ(found.status, Status::limit);
  EXPECT_EQ(found.order, (std::vector{0, 1}));
  TourRequest many;
  many.points.assign(251, {30, 20});
  EXPECT_THROW((void)plan_tour(planner, many), Error);  // 2008 poses
  request.stop = fired();
  EXPECT_EQ(plan_tour(planner, request).status, Status::interrupted);
}

}  // namespace
}  // namespace lasius::vehicle
