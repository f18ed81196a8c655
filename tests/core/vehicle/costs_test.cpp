// Vehicles over costs: what paths cost against sums at points close together, bounds against paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/vehicle/angle.h"
#include "core/vehicle/prices.h"
#include "lasius/error.h"
#include "lasius/vehicle/planner.h"
#include "tests/core/vehicle/dense_check.h"

namespace lasius::vehicle {
namespace {

CostField hilly(const Grid& grid, std::uint64_t seed, double scale = 1) {
  std::mt19937_64 random(seed);
  std::vector<double> weights;
  for (int i = 0; i < grid.width() * grid.height(); ++i)
    weights.push_back(scale * (1 + static_cast<double>(random() % 1000) / 200));
  return CostField(grid.width(), grid.height(), weights);
}

double weight_at(const CostField& costs, const Pose& at) {
  const auto in = [](double v, int side) {
    return std::clamp(static_cast<int>(std::floor(v)), 0, side - 1);
  };
  return costs.weight({in(at.x, costs.width()), in(at.y, costs.height())});
}

/// By the formulas of docs/vehicles.md, at the middles of many short pieces.
double summed(const CostField& costs, const Vehicle& vehicle, const std::vector<Segment>& path) {
  double sum = 0;
  int gear = 0;
  for (const Segment& s : path) {
    if (s.gear == 0) {
      sum += std::fabs(s.angle) * vehicle.rotation_cost * weight_at(costs, s.begin);
      continue;
    }
    if (gear != 0 && gear != s.gear) sum += vehicle.cusp_cost * weight_at(costs, s.begin);
    gear = s.gear;
    const int pieces = 1 + static_cast<int>(s.length * 2000);
    double along = 0;
    for (int i = 0; i < pieces; ++i)
      along += weight_at(costs, s.pose((i + 0.5) * s.length / pieces));
    sum += along * s.length / pieces * (s.gear < 0 ? vehicle.reverse_cost : 1);
  }
  return sum;
}

Vehicle truck() {
  Vehicle made = car(rectangle(2, 5, 2.5), 6);
  made.rotate_in_place = true;
  made.cusp_cost = 1.5;
  return made;
}

TEST(VehicleCosts, AreTheIntegralOfTheWeight) {
  const Grid grid(60, 50);
  const CostField costs = hilly(grid, 3, 0.25);
  const Planner planner(grid, truck(), costs);
  const std::vector<std::vector<Segment>> paths = {
      {{.begin = {5.3, 4.7, 0.4}, .length = 31.7}},
      {{.begin = {5.5, 4.5, 0}, .length = 31}},
      {{.begin = {30, 25, 1}, .curvature = 1 / 6.0, .length = 36}},
      {{.begin = {30, 25, 1}, .curvature = -1 / 90.0, .length = 24, .gear = -1}},
      {{.begin = {30, 25, 1}, .gear = 0, .angle = -2}},
      {{.begin = {20.2, 20.9, 0}, .length = 7},
       {.begin = {27.2, 20.9, 0}, .curvature = 1 / 8.0, .length = 5, .gear = -1}},
      // Out of the map, where the nearest cell counts.
      {{.begin = {50.5, 40.5, 0.5}, .length = 30}}};
  for (const std::vector<Segment>& path : paths) {
    const double there = summed(costs, truck(), path);
    EXPECT_NEAR(planner.cost(path), there, 5e-4 * there);
  }
}

TEST(VehicleCosts, OfTheLatticeAreThoseOfItsMotions) {
  const Grid grid(60, 50);
  const CostField costs = hilly(grid, 5);
  const Vehicle vehicle = truck();
  const Prices prices(grid, vehicle, &costs);
  const Lattice lattice(vehicle, Outline(vehicle));
  const EdgePrices edges(prices, vehicle, lattice);
  for (std::size_t e = 0; e < lattice.edges().size(); ++e) {
    std::vector<Segment> motions;
    lattice.append(lattice.edges()[e], 30, 25, motions);
    const double alone = prices.of(motions);
    ASSERT_NEAR(edges.at(static_cast<int>(e), 30, 25), alone, 1e-4 * alone) << e;
    ASSERT_GE(alone, cost(vehicle, motions) - 1e-4);
  }
}

TEST(VehicleCosts, OfOneWeightGiveThePathsWithout) {
  const Grid grid = blobs(11, 25);
  CostField costs(grid.width(), grid.height());
  costs.add(std::vector<double>(static_cast<std::size_t>(grid.width()) * grid.height(), 1.5));
  const Planner plain(grid, truck()), even(grid, truck(), costs);
  const Request request{.start = {8, 8, 0.3}, .goals = {{130, 104, 2}}};
  const Result one = plain.plan(request), other = even.plan(request);
  ASSERT_EQ(one.status, Status::solved) << one.error;
  EXPECT_EQ(one.segments, other.segments);
  EXPECT_EQ(2.5 * one.cost, other.cost);
  EXPECT_EQ(2.5 * *one.lower_bound, *other.lower_bound);
  EXPECT_EQ(one.length, other.length);
}

TEST(VehicleCosts, LeadRoundDearGround) {
  Grid grid(90, 50);
  CostField costs(90, 50);
  std::vector<double> dear(90 * 50, 0);
  for (int y = 0; y < 35; ++y)
    for (int x = 35; x < 55; ++x) dear[static_cast<std::size_t>(y) * 90 + x] = 1;
  costs.add(dear, 9);
  const Vehicle vehicle = car(rectangle(1, 3, 1.5), 4);
  const Planner planner(grid, vehicle, costs);
  const Result result = planner.plan({.start = {10, 15, 0}, .goals = {{80, 15, 0}}});
  ASSERT_EQ(result.status, Status::solved) << result.error;
  EXPECT_LT(result.cost, 70 + 20 * 4.5);  // straight on it is 70 + 20 * 9
  EXPECT_GT(result.length, 78);
  EXPECT_LE(*result.gap(), 0.04);
  EXPECT_NEAR(result.cost, summed(costs, vehicle, result.segments), 1e-3 * result.cost);
}

// No path, whichever search found it, is cheaper than the bound; smoothing lowers the cost.
TEST(VehicleCosts, AreAboveTheirBound) {
  const Grid grid = blobs(7, 22);
  CostField costs = hilly(grid, 9, 0.5);
  costs.add(grid, Inflation{.radius = 8, .scaling = 0.3, .weight = 3, .inscribed = 2});
  double without = 0, over = 0;
  int found = 0;
  for (const double cusp_cost : {0.0, 1.5}) {
    Vehicle vehicle = truck();
    vehicle.cusp_cost = cusp_cost;
    const Planner plain(grid, vehicle), planner(grid, vehicle, costs);
    std::mt19937_64 random(4);
    for (int i = 0; i < 7; ++i) {
      const auto draw = [&] {
        Pose pose;
        do {
          pose = {static_cast<double>(random() % kSide), static_cast<double>(random() % 120),
                  static_cast<double>(random() % 6)};
        } while (!planner.space().free(pose));
        return pose;
      };
      Request request{.start = draw(), .goals = {}};
      request.goals.push_back(draw());
      const Result cheap = planner.plan(request), brief = plain.plan(request);
      request.smooth = false;
      const Result raw = planner.plan(request);
      if (cheap.goal < 0 || brief.goal < 0) continue;
      ++found;
      EXPECT_TRUE(cheap.over_costs);
      EXPECT_GT(*cheap.lower_bound, 0);
      EXPECT_LE(*cheap.lower_bound, std::min(cheap.cost, planner.cost(brief.segments)));
      EXPECT_LE(cheap.cost, raw.cost);
      EXPECT_NEAR(cheap.cost, summed(costs, vehicle, cheap.segments), 1e-3 * cheap.cost);
      EXPECT_EQ(planner.plan(request).segments, raw.segments);
      without += planner.cost(brief.segments);
      over += cheap.cost;
    }
  }
  EXPECT_GE(found, 11);
  EXPECT_LT(over, 0.97 * without);
}

TEST(VehicleCosts, AreOfTheMapsSize) {
  EXPECT_THROW(Planner(Grid(20, 20), truck(), CostField(20, 21)), Error);
}

}  // namespace
}  // namespace lasius::vehicle
