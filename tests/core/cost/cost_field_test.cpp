// Weights: layers, inflation, what is refused; the cost of a polyline.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/cost/field.h"
#include "tests/core/base/refusal.h"
#include "tests/oracle/cost_paths.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

constexpr double kRoot2 = 1.4142135623730951;

TEST(CostField, SlopesAreGradients) {
  // Heights 3 x + y^2: by hand, one-sided at the edges.
  std::vector<double> heights;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 2; ++x) heights.push_back(3 * x + y * y);
  const std::vector<double> slopes = slope(2, 3, heights);
  const double expected[] = {std::sqrt(10.0), std::sqrt(10.0), std::sqrt(13.0),
                             std::sqrt(13.0), std::sqrt(18.0), std::sqrt(18.0)};
  ASSERT_EQ(slopes.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(slopes[i], expected[i]);
  EXPECT_EQ(slope(1, 1, std::vector<double>{7}), std::vector<double>{0});
  EXPECT_THROW((void)slope(2, 2, heights), Error);
  heights[3] = std::nan("");
  EXPECT_THROW((void)slope(2, 3, heights), Error);
}

TEST(CostField, AddsLayersToOne) {
  CostField costs(2, 1);
  costs.add(std::vector<double>{0.5, 3}, 2);
  costs.add(std::vector<double>{1, 0});
  EXPECT_EQ(costs.weight({0, 0}), 3);
  EXPECT_EQ(costs.weight({1, 0}), 7);
  const Grid grid = drawn({".#"});
  EXPECT_EQ(costs.range(grid).least, 3);
  EXPECT_EQ(costs.range(grid).most, 3);
  EXPECT_NE(costs.hash(), CostField(2, 1).hash());
  EXPECT_NE(CostField(1, 2).hash(), CostField(2, 1).hash());
}

TEST(CostField, ACostmapBlocksAndCosts) {
  const std::vector<std::uint8_t> values{0, 63, 252, 253, 254, 255};
  const Costmap known = read_costmap(3, 2, values, 4);
  EXPECT_EQ(known.grid, drawn({"...", "###"}));
  EXPECT_EQ(known.costs.weight({0, 0}), 1);
  EXPECT_EQ(known.costs.weight({1, 0}), 2);
  EXPECT_EQ(known.costs.weight({2, 0}), 5);
  const Costmap unknown = read_costmap(3, 2, values, 4, true);
  EXPECT_EQ(unknown.grid, drawn({"...", "##."}));
  EXPECT_EQ(unknown.costs.weight({2, 1}), 1);
  EXPECT_THROW(read_costmap(3, 3, values), Error);
  EXPECT_THROW(read_costmap(3, 2, values, -1), Error);
}

TEST(CostField, RefusesWhatIsNoCost) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CostField costs(3, 1);
  const auto added = [&](std::vector<double> values, double factor) {
    return refusal([&] { costs.add(values, factor); });
  };
  expect_says(added({1, 2}, 1), "2 values for a map of 3 x 1");
  for (const double bad : {-1.0, nan, infinity})
    expect_says(added({0, 0, bad}, 1), "in cell (2, 0)");
  for (const double bad : {-1.0, nan, infinity}) expect_says(added({0, 0, 0}, bad), "factor");
  expect_says(added({0, 1e6, 0}, 1), "at most");
  EXPECT_EQ(costs.hash(), CostField(3, 1).hash());  // as before
  for (const double bad : {0.0, -1.0, nan, 2e6})
    expect_says(refusal([&] { CostField(1, 1, std::vector{bad}); }), "weight");
  expect_says(refusal([] { CostField(0, 1); }), "0 x 1");
  expect_says(refusal([&] { costs.range(Grid(1, 3)); }), "3 x 1");
  for (const Inflation& bad : {Inflation{-1, 1}, Inflation{nan, 1}, Inflation{1, -1},
                               Inflation{1, 1, -2}, Inflation{1, 1, 2, infinity}})
    expect_says(refusal([&] { costs.add(Grid(3, 1), bad); }), "inflation");
}

// By hand, from Nav2's formula; and against the distance to every blocked cell.
TEST(CostField, InflatesByCentres) {
  const Grid line = drawn({"#......"});
  CostField costs(7, 1);
  costs.add(line, {.radius = 4, .scaling = 0.5, .weight = 3, .inscribed = 1.5});
  EXPECT_EQ(costs.weight({1, 0}), 1 + 3);
  EXPECT_NEAR(costs.weight({2, 0}), 1 + 3 * std::exp(-0.25), 1e-11);
  EXPECT_NEAR(costs.weight({4, 0}), 1 + 3 * std::exp(-1.25), 1e-11);
  EXPECT_EQ(costs.weight({5, 0}), 1);
  std::mt19937 random(1);
  for (int i = 0; i < 40; ++i) {
    const int width = 1 + static_cast<int>(random() % 20),
              height = 1 + static_cast<int>(random() % 20);
    const Grid grid = random_grid(width, height, static_cast<int>(random() % 30), random);
    const double radius = 0.25 * static_cast<double>(random() % 40);
    CostField field(width, height);
    field.add(grid, {.radius = radius, .scaling = 0.7, .weight = 2, .inscribed = 0});
    for (const Cell c : cells_of(grid)) {
      if (grid.blocked(c)) continue;
      double d = 1e9;
      for (const Cell b : cells_of(grid)) {
        if (grid.blocked(b)) d = std::min(d, std::hypot(b.x - c.x, b.y - c.y));
      }
      const double want = d > radius ? 0 : d <= 1 ? 2 : 2 * std::exp(-0.7 * (d - 1));
      EXPECT_NEAR(field.weight(c), 1 + want, 1e-11);
    }
  }
}

TEST(PathCost, ByHand) {
  const Grid grid = drawn({"..#",  //
                           ".#.",  //
                           "..."});
  const CostField costs(3, 3, std::vector<double>{1, 2, 9, 3, 9, 5, 4, 6, 7});
  const auto cost = [&](std::vector<Point> path) { return path_cost(grid, costs, path); };
  EXPECT_EQ(cost({}), 0);
  EXPECT_DOUBLE_EQ(*cost({{0.5, 0.5}, {1.5, 0.5}}), 1.5);
  EXPECT_DOUBLE_EQ(*cost({{0, 0}, {0, 3}}), 8);                           // along the map's edge
  EXPECT_DOUBLE_EQ(*cost({{1, 0}, {1, 3}}), 1 + 3 + 4);                   // the cheaper free side
  EXPECT_DOUBLE_EQ(*cost({{0.5, 1.5}, {1.5, 2.5}}), kRoot2 * (1.5 + 3));  // past a blocked corner
  EXPECT_DOUBLE_EQ(*cost({{1, 2}, {2, 2}, {2.5, 1.5}}), 6 + 5 / kRoot2);
  EXPECT_FALSE(cost({{0.5, 1.5}, {2.5, 1.5}}));              // through a blocked cell
  EXPECT_FALSE(cost({{2, 0}, {2, 1}, {3, 1}, {1.5, 0.5}}));  // a squeeze
  EXPECT_FALSE(cost({{1.5, 0.5}, {2, 1}, {2.5, 1.5}}));      // the same
  EXPECT_FALSE(cost({{-0.5, 1}, {0.5, 1}}));                 // outside
}

TEST(PathCost, AgreesWithSampling) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0, 6), weight(0.5, 9);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const Grid grid = random_grid(6, 6, 10, random);
    std::vector<double> weights(36);
    for (double& w : weights) w = weight(random);
    const CostField costs(6, 6, weights);
    const std::vector<Point> path{{place(random), place(random)}, {place(random), place(random)}};
    const auto cost = path_cost(grid, costs, path);
    if (!cost) continue;
    ++compared;
    const auto of = [&](Cell c) { return costs.weight(c); };
    EXPECT_NEAR(*cost, oracle::sampled_cost(grid, of, path, 20000), 2e-3 * *cost);
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace lasius
