// The search over costs against brute force: its bound is never above what a path costs, its path
// costs what it says and no more than the best that others find.
#include "core/cost/cost_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/cost/goal_field.h"
#include "core/cost/straightened.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/cost_paths.h"
#include "tests/oracle/relaxed_walks.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/weights.h"

namespace lasius::cost {
namespace {

TEST(CostSearch, TinyMapsAgainstBruteForce) {
  std::mt19937 random(7);
  double worst_gap = 0;
  for (int i = 0; i < 150; ++i) {
    const auto [grid, costs, start, goal] = random_weights(random, 4, 8);
    const Terrain terrain(grid, costs);
    CostSearch search;
    CostAnswer answer;
    search.search(terrain, {start, goal}, {}, {}, answer);
    const auto weight = [&costs = costs](Cell c) { return costs.weight(c); };
    const double best = oracle::cost_over_points(grid, weight, centre(start), centre(goal), 7);
    ASSERT_FALSE(answer.path.empty());
    EXPECT_NEAR(*path_cost(grid, costs, answer.path), answer.length, 1e-9 * answer.length);
    EXPECT_LE(answer.length, best * (1 + 1e-9)) << i;
    EXPECT_GE(answer.length, best * 0.97);
    for (const auto& level : search.levels()) {
      EXPECT_LE(level.lower, std::min(best, answer.length) * (1 + 1e-12)) << i;
      EXPECT_LT(level.excess, 1 + 1e-6);
    }
    worst_gap = std::max(worst_gap, answer.length / answer.lower_bound - 1);
  }
  EXPECT_LT(worst_gap, 0.003);
}

// A dear cell that both ends are in is left where the way around it, or around more, is cheaper; so
// is one beside the goal's, for a way that comes back to its boundary.
TEST(CostSearch, EndsInOneCellOrBesideAgainstBruteForce) {
  std::mt19937 random(41);
  const auto place = [&] {
    return std::clamp(static_cast<double>(random() % 101) / 100, 1e-4, 1 - 1e-4);
  };
  int around = 0, asked = 0;
  double gaps = 0;
  for (int i = 0; i < 1200; ++i) {
    auto [grid, costs, cell, other] = random_weights(random, 4, 6);
    const Point from{place(), place()}, to{place(), place()};
    Cell goal = cell;
    if (i % 3 == 1) goal.x += cell.x > 0 ? -1 : 1;
    if (i % 3 == 2) goal.y += cell.y > 0 ? -1 : 1;
    if (!grid.free(goal)) continue;
    std::vector<double> weights(costs.weights().begin(), costs.weights().end());
    for (const Cell c : {cell, goal})
      weights[c.y * grid.width() + c.x] *= static_cast<double>(1 + random() % 20);
    if (i % 2 == 0) costs = CostField(grid.width(), grid.height(), weights);
    const Terrain terrain(grid, costs);
    const Point begin{cell.x + from.x, cell.y + from.y}, end{goal.x + to.x, goal.y + to.y};
    if (begin == end) continue;
    ++asked;
    const double straight = *path_cost(grid, costs, std::vector{begin, end});
    CostSearch search;
    CostAnswer answer;
    search.search(terrain, {cell, goal, from, to}, {}, {}, answer);
    const auto weight = [&costs = costs](Cell c) { return costs.weight(c); };
    const double best = oracle::cost_over_points(grid, weight, begin, end, 9);
    const auto cost = path_cost(grid, costs, answer.path);
    ASSERT_TRUE(cost) << i;
    EXPECT_NEAR(*cost, answer.length, 1e-9 * answer.length);
    EXPECT_LE(answer.length, best * (1 + 1e-9)) << i;
    EXPECT_LE(answer.lower_bound, best * (1 + 1e-12)) << i;
    around += answer.length < 0.9 * straight ? 1 : 0;
    gaps += answer.length / answer.lower_bound - 1;
  }
  EXPECT_GT(around, 20);
  EXPECT_LT(gaps / asked, 0.01);
}

TEST(CostSearch, StraightWhereWeightsAreEqual) {
  const Grid grid(40, 30);
  const Terrain terrain(grid, CostField(40, 30));
  CostSearch search;
  CostAnswer answer;
  search.search(terrain, {{2, 3}, {37, 21}}, {}, {}, answer);
  EXPECT_NEAR(answer.length, std::hypot(35, 18), 1e-9);
  EXPECT_GT(answer.lower_bound, answer.length * 0.999);
}

// Refraction: between two half planes a path bends as light does.
TEST(CostSearch, BendsAsLightDoes) {
  const Grid grid(20, 20);
  std::vector<double> weights(400, 1);
  std::fill(weights.begin() + 200, weights.end(), 2.5);
  const Terrain terrain(grid, CostField(20, 20, weights));
  CostSearch search;
  CostAnswer answer;
  search.search(terrain, {{2, 2}, {17, 17}}, {}, {}, answer);
  double best = 1e300;
  for (int i = 0; i <= 200000; ++i) {
    const double x = 2.5 + 15.0 * i / 200000;
    best = std::min(best, std::hypot(x - 2.5, 7.5) + 2.5 * std::hypot(17.5 - x, 7.5));
  }
  EXPECT_NEAR(answer.length, best, 1e-8);
}

TEST(CostSearch, EightMovesAgainstDijkstra) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const WeightedWorld world = random_weights(random, 4, 12);
    const auto& [grid, costs, start, goal] = world;
    const Terrain terrain(grid, costs);
    for (const Corners corners : {Corners::forbid, Corners::one_side, Corners::allow}) {
      const auto cost = [&](Cell c, oracle::Step step) {
        const Cell to{c.x + step.dx, c.y + step.dy};
        return oracle::move_length(c, step) * (world.costs.weight(c) + world.costs.weight(to)) / 2;
      };
      const auto least = oracle::relaxed_walks(grid, start, Neighbours::eight, corners, cost);
      CostSearch search;
      CostAnswer answer;
      search.search_eight_moves(terrain, start, goal, corners, {}, answer);
      EXPECT_NEAR(answer.length, least[goal.y * grid.width() + goal.x], 1e-9 * answer.length);
      EXPECT_TRUE(answer.optimal);
    }
  }
}

// Both ends' searches meet far from either: against D* Lite, which has one end and another order.
TEST(CostSearch, EightMovesFromBothEndsOnLargerMaps) {
  std::mt19937 random(29);
  Poller poller(kNeverStops);
  EightMoves moves;
  for (int i = 0; i < 60; ++i) {
    const WeightedWorld world = random_weights(random, 30, 90);
    const auto& [grid, costs, start, goal] = world;
    const Terrain terrain(grid, costs);
    const auto cost_along = [&terrain](const std::vector<Cell>& walk) {
      double sum = 0;
      for (std::size_t at = 1; at < walk.size(); ++at)
        sum += terrain.move_cost(walk[at - 1], walk[at]);
      return sum;
    };
    for (const bool squeezes : {false, true}) {
      const Corners corners = squeezes ? Corners::allow : Corners::forbid;
      GoalField field(terrain, goal, terrain.least(), squeezes);
      ASSERT_TRUE(field.update(start, poller));
      const auto want = field.walk();
      const auto walk = moves.search(terrain, start, goal, corners, poller, false);
      ASSERT_EQ(walk.empty(), want.empty()) << i;
      EXPECT_NEAR(cost_along(walk), cost_along(want), 1e-11 * cost_along(want)) << i;
      if (walk.empty()) continue;
      EXPECT_EQ(walk.front(), start);
      EXPECT_EQ(walk.back(), goal);
    }
  }
}

TEST(CostSearch, WalksThatAreNoneOrHaveOneCell) {
  const Grid grid = walled(9, 9, {{4, 0, 1, 9}});
  const Terrain terrain(grid, CostField(9, 9));
  Poller poller(kNeverStops);
  EightMoves moves;
  for (const bool knights : {false, true}) {
    EXPECT_TRUE(moves.search(terrain, {0, 0}, {8, 8}, Corners::allow, poller, knights).empty());
    EXPECT_EQ(moves.search(terrain, {1, 2}, {1, 2}, Corners::allow, poller, knights),
              (std::vector<Cell>{{1, 2}}));
  }
}

TEST(CostSearch, AStraightWalkIsOnePiece) {
  const Grid grid(9, 3);
  const std::vector<Cell> walk = cells_of(Rectangle{0, 1, 8, 1});
  EXPECT_EQ(straightened(Terrain(grid, CostField(9, 3)), walk).size(), walk.size());
}

TEST(CostSearch, FirstPathsFollowAWalkWithAKnightsMoves) {
  std::mt19937 random(17);
  int cheaper = 0;
  double dearer = 0;
  for (int i = 0; i < 60; ++i) {
    const WeightedWorld world = random_weights(random, 30, 50);
    const auto& [grid, costs, start, goal] = world;
    const Terrain terrain(grid, costs);
    double walked[2] = {};
    for (const bool knights : {false, true}) {
      EightMoves moves;
      Poller poller(kNeverStops);
      std::vector<Point> path;
      for (const Cell c : moves.search(terrain, start, goal, Corners::one_side, poller, knights))
        path.push_back(centre(c));
      walked[knights ? 1 : 0] = path_cost(grid, costs, path).value_or(kInfinity);
    }
    EXPECT_LE(walked[1], walked[0] * (1 + 1e-12)) << i;
    cheaper += walked[1] < walked[0] * (1 - 1e-9) ? 1 : 0;
    CostSearch search;
    CostAnswer answer;
    search.search(terrain, {start, goal}, {.target_gap = 0.001}, {}, answer);
    EXPECT_LE(search.levels().front().upper, walked[1]);
    dearer += search.levels().front().upper / answer.length - 1;
  }
  EXPECT_GT(cheaper, 30);
  EXPECT_LT(dearer / 60, 0.001);
}

// Levels that end where a target gap is proven leave the path as cheap as it was.
TEST(CostSearch, TargetGapsAreProvenByLessAndPathsStayCheap) {
  std::mt19937 random(31);
  double dearer = 0;
  for (int i = 0; i < 40; ++i) {
    const WeightedWorld world = random_weights(random, 30, 60);
    const Terrain terrain(world.grid, world.costs);
    CostSearch search;
    CostAnswer whole, answer;
    search.search(terrain, {world.start, world.goal}, {}, {}, whole);
    for (const double gap : {0.03, 0.01, 0.002}) {
      search.search(terrain, {world.start, world.goal}, {.target_gap = gap}, {}, answer);
      EXPECT_LE(answer.length - answer.lower_bound, gap * answer.lower_bound) << i;
      EXPECT_LE(answer.lower_bound, whole.length * (1 + 1e-12)) << i;
      EXPECT_LE(answer.length, whole.length * 1.003) << i;
      dearer += answer.length / whole.length - 1;
    }
  }
  EXPECT_LT(dearer / 120, 1e-4);
}

// Weights of six orders of magnitude: keys go a million buckets far.
TEST(CostSearch, WeightsOfAllOrders) {
  std::mt19937 random(37);
  std::vector<double> weights(40 * 40);
  for (double& w : weights) w = std::exp(13 * static_cast<double>(random() % 1000) / 1000);
  const Grid grid(40, 40);
  const CostField costs(40, 40, weights);
  const Terrain terrain(grid, costs);
  CostSearch search;
  CostAnswer answer, walk;
  search.search(terrain, {{1, 2}, {38, 36}}, {}, {}, answer);
  search.search_eight_moves(terrain, {1, 2}, {38, 36}, Corners::one_side, {}, walk);
  EXPECT_LE(answer.length, walk.length);
  EXPECT_NEAR(*path_cost(grid, costs, answer.path), answer.length, 1e-9 * answer.length);
  EXPECT_LE(answer.length, answer.lower_bound * 1.001);
}

TEST(CostSearch, StopsAtTheTargetGap) {
  std::mt19937 random(11);
  const WeightedWorld world = random_weights(random, 40, 60);
  const auto& [grid, costs, start, goal] = world;
  const Terrain terrain(grid, costs);
  double bound = 0;
  int paths = 0;
  const OnImproved told = [&](const std::vector<Point>& path, double cost, double lower) {
    EXPECT_NEAR(*path_cost(world.grid, world.costs, path), cost, 1e-9 * cost);
    EXPECT_LE(lower, cost);
    bound = lower;
    ++paths;
    return true;
  };
  for (const double gap : {0.05, 0.01, 0.0005}) {
    CostSearch search;
    CostAnswer answer;
    search.search(terrain, {start, goal}, {.target_gap = gap, .improved = &told}, {}, answer);
    EXPECT_LE(answer.length - answer.lower_bound, gap * answer.lower_bound);
    EXPECT_GE(answer.lower_bound, bound * (1 - 1e-9));
  }
  EXPECT_GE(paths, 3);
  CostSearch search;
  CostAnswer answer;
  search.search(terrain, {start, goal}, {}, fired(), answer);
  EXPECT_EQ(answer.cause, StopCondition::Cause::token);
  EXPECT_LE(answer.lower_bound, answer.path.empty() ? 0 : answer.length);
}

}  // namespace
}  // namespace lasius::cost
