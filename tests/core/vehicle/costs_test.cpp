// Vehicles over costs: what paths cost against sums at points close together, bounds against paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "core/vehicle/bound.h"
#include "core/vehicle/flood.h"
#include "core/vehicle/prices.h"
#include "lasius/base/error.h"
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

// What is driven in a cell is summed as it is driven, whatever the library's sort does.
TEST(VehicleCosts, OfTheLatticeAreSummedInOrder) {
  const Grid grid(200, 200);
  const CostField costs = hilly(grid, 5);
  for (const double radius : {6.0, 30.0}) {
    Vehicle vehicle = truck();
    vehicle.turning_radius = radius;
    const Prices prices(grid, vehicle, &costs);
    const Lattice lattice(vehicle, Outline(vehicle));
    const EdgePrices edges(prices, vehicle, lattice);
    for (std::size_t e = 0; e < lattice.edges().size(); ++e) {
      const Edge& edge = lattice.edges()[e];
      if (edge.gear == 0) continue;
      std::vector<Segment> motions;
      lattice.append(edge, 0, 0, motions);
      std::map<std::pair<int, int>, double> driven;
      for (const Segment& s : motions) {
        std::vector<std::pair<std::pair<int, int>, double>> parts;
        Point from{s.begin.x, s.begin.y};
        const auto even = [](int, int) { return 1.0; };
        const auto take = [&](Cell cell, Point to) {
          parts.push_back({{cell.y, cell.x}, distance(from, to)});
          from = to;
        };
        cost::PathCost sum(even, take);
        const double longer =
            walk_cells(s, s.length, sum) * (edge.gear < 0 ? vehicle.reverse_cost : 1);
        for (const auto& [cell, length] : parts) driven[cell] += length * longer;
      }
      double sum = 0;
      for (const auto& [cell, price] : driven)
        sum += price * prices.weight(100 + cell.second, 100 + cell.first);
      EXPECT_EQ(edges.at(static_cast<int>(e), 100, 100), sum) << radius << ' ' << e;
    }
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
    const Prices prices(grid, vehicle, &costs);
    const Bound bound(grid, vehicle, prices);
    std::mt19937_64 random(4);
    for (int i = 0; i < 7; ++i) {
      Request request = random_request(planner.space(), random);
      const Result cheap = planner.plan(request), brief = plain.plan(request);
      request.smooth = false;
      const Result raw = planner.plan(request);
      if (cheap.goal < 0 || brief.goal < 0) continue;
      ++found;
      EXPECT_TRUE(cheap.over_costs);
      ASSERT_TRUE(cheap.lower_bound);
      // The bound itself, as it is before it is told.
      const double least = bound.least(request);
      EXPECT_EQ(*cheap.lower_bound, prices.unit() * least);
      for (const Result* path : {&cheap, &brief, &raw}) {
        EXPECT_LE(least, (1 + 1e-9) * prices.of(path->segments));
      }
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

TEST(VehicleCosts, TellNoBoundThatIsAbovePaths) {
  EXPECT_EQ(Bound::told(7, 8, true), 7.0);
  EXPECT_EQ(Bound::told(8.005, 8, true), 8.0);
  EXPECT_EQ(Bound::told(8.01, 8, true), std::nullopt);
  EXPECT_EQ(Bound::told(8.005, 8, false), std::nullopt);
  EXPECT_EQ(Bound::told(8 + 1e-9, 8, false), 8.0);
  EXPECT_EQ(Bound::told(std::numeric_limits<double>::infinity(), 8, true), std::nullopt);
}

// Sources over weights may cost more than 32 bits have levels for, and have much between them.
TEST(VehicleCosts, OfSourcesMayBeAnyNumber) {
  Grid grid(60, 30);
  grid.fill({40, 0, 8, 30}, true);
  const Vehicle vehicle = omni(rectangle(1, 1, 1));
  const CostField costs = hilly(grid, 2);
  const Prices prices(grid, vehicle, &costs);
  const Space space(grid, vehicle);
  const Lattice lattice(vehicle, space.impl().outline());
  Poller poller(kGoesOn, 1);
  const FreeHeadings free(space.impl(), lattice, poller);
  Flood::Memory memory;
  const auto flooded = [&](double first, double far, Poller& by) {
    Flood flood(free, space.impl(), prices, false, memory, by);
    flood.add_source(30, 20, first + 7);
    flood.add_source(5, 6, first);
    flood.add_source(55, 6, first + far);
    std::vector<double> told;
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 60; ++x) told.push_back(flood.at(x, y));
    return told;
  };
  const std::vector<double> near = flooded(0, 500, poller);
  EXPECT_NEAR(near[6 * 60 + 5], 0, 1e-12);
  EXPECT_NEAR(near[6 * 60 + 55], 500, 1e-12);
  for (const double first : {1e6, 7.4e7, 1e12}) {
    (void)poller.take_work();
    const std::vector<double> told = flooded(first, 3e7, poller);
    EXPECT_LT(poller.take_work(), 200'000);  // of levels where nothing is there are 870 million
    for (std::size_t i = 0; i < told.size(); ++i) {
      if (near[i] > 1e29) {
        EXPECT_EQ(told[i], near[i]);
      } else {
        ASSERT_NEAR(told[i], first + near[i] + (i % 60 > 44 ? 3e7 - 500 : 0), 1e-6 + first * 1e-15)
            << i;
      }
    }
  }
  // Beyond the last level all is as far.
  const std::vector<double> last = flooded(1e12, 1e11, poller);
  EXPECT_NEAR(last[6 * 60 + 55], 1e12 + 3.7e7, 1e6);
  EXPECT_EQ(last[20 * 60 + 55], last[6 * 60 + 55]);
  const StopCondition past{.deadline = Clock::time_point::min()};
  Poller late(past, 1);
  EXPECT_GT(flooded(0, 500, late)[29 * 60 + 39], 1e29);
}

TEST(VehicleCosts, MayDifferByAsMuchAsTheyMay) {
  const Grid grid(160, 80);
  std::vector<double> weights(160 * 80, 1e-6);
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (i % 160 >= 60) weights[i] = 1e4;
  const CostField costs(160, 80, weights);
  const Planner planner(grid, car(rectangle(1, 3, 1.5), 4), costs);
  const Result result =
      planner.plan({.start = {20, 40, 0}, .goals = {{130, 40, 1}}, .bound = false});
  ASSERT_EQ(result.status, Status::solved) << result.error;
  EXPECT_LE(result.cost, 72e4);
}

TEST(VehicleCosts, AreOfTheMapsSize) {
  EXPECT_THROW(Planner(Grid(20, 20), truck(), CostField(20, 21)), Error);
}

}  // namespace
}  // namespace lasius::vehicle
