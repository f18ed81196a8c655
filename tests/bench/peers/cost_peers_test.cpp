#include "bench/peers/cost_peers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "lasius/cost/planner.h"
#include "tests/oracle/cost_paths.h"
#include "tests/worlds/grids.h"

namespace lasius::peers {
namespace {

CostField random_weights(const Grid& grid, std::mt19937& random) {
  std::uniform_real_distribution<double> weight(1, 6);
  std::vector<double> weights(static_cast<std::size_t>(grid.width()) * grid.height());
  for (double& value : weights) value = weight(random);
  return {grid.width(), grid.height(), weights};
}

// Two cells of weight 1 and 4 over one another; two blocked cells that touch at (4, 1).
TEST(PathIntegral, CountsTheCheaperSideOfALineAndRefusesASqueeze) {
  const Grid grid = with_blocked(5, 2, {{3, 0}, {4, 1}});
  const CostField costs(5, 2, std::array<double, 10>{1, 1, 1, 1, 1, 4, 4, 4, 4, 4});
  const WeightedMap map(grid, costs);
  PathIntegral integral(map);
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const struct {
    std::vector<Point> path;
    double cost;
  } cases[] = {
      {{{0.5, 0.5}}, 0},
      {{{0.5, 0.5}, {2.5, 0.5}}, 2},
      {{{0.5, 0.5}, {0.5, 1.5}}, 2.5},
      {{{0.25, 1}, {2.25, 1}}, 2},                // the line between them
      {{{2.5, 1}, {3.5, 1}}, 0.5 * 1 + 0.5 * 4},  // whose upper side is blocked from x = 3
      {{{0.5, 1.5}, {1.5, 0.5}}, std::sqrt(0.5) * (4 + 1)},  // through a corner
      {{{3.5, 1.5}, {4.5, 0.5}}, kNever},                    // a squeeze
      {{{3.5, 1.5}, {4, 1}, {4.5, 0.5}}, kNever},
      {{{2.5, 0.5}, {3.5, 0.5}}, kNever},
      {{{0.5, 0.5}, {-0.5, 0.5}}, kNever},
      {{{0.5, 0.5}, {0.5, 0.5}, {1, 0.5}}, 0.5},
  };
  for (const auto& [path, cost] : cases) {
    if (cost == kNever)
      EXPECT_EQ(integral.of(path), kNever) << path.front().x << ',' << path.front().y;
    else
      EXPECT_NEAR(integral.of(path), cost, 1e-12) << path.front().x << ',' << path.front().y;
  }
}

TEST(CostPeers, FindAllowedPathsNoneBelowTheProvenBound) {
  std::mt19937 random(3);
  std::bernoulli_distribution blocked(0.15);
  const std::pair<const char*, std::unique_ptr<QueryPlanner> (*)(const WeightedMap&)> kPeers[] = {
      {"heap", cost_heap_astar},
      {"buckets", cost_bucket_astar},
      {"theta", cost_theta_star},
      {"field d*", field_dstar},
      {"fast marching", fast_marching}};
  int found = 0, missed = 0;
  std::array<double, std::size(kPeers)> dearer{};
  for (int round = 0; round < 60; ++round) {
    const Grid grid =
        grid_of(12 + round % 9, 10 + round % 7, [&](int, int) { return blocked(random); });
    const CostField costs = random_weights(grid, random);
    const WeightedMap map(grid, costs);
    PathIntegral integral(map);
    const CostPlanner planner(Planner(grid), costs);
    const Cell start = random_cell(grid, random), goal = random_cell(grid, random);
    if (!grid.free(start) || !grid.free(goal) || start == goal) continue;
    const Request request{.start = start, .goal = goal};
    const auto ours = planner.plan(request);
    const double bound = ours.lower_bound.value_or(0) * (1 - 1e-9);
    const auto moves = planner.plan(request, {.eight_moves = true, .corners = Corners::one_side});
    for (std::size_t i = 0; i < std::size(kPeers); ++i) {
      const auto& [name, make] = kPeers[i];
      std::vector<Point> path;
      const double cost = make(map)->plan(start, goal, path);
      if (path.empty()) {
        // Fields may be led astray; the others answer whenever there is a path.
        ASSERT_TRUE(ours.path.empty() || i >= 3) << name << ' ' << round;
        missed += ours.path.empty() ? 0 : 1;
        continue;
      }
      EXPECT_EQ(path.front(), centre(start));
      EXPECT_EQ(path.back(), centre(goal));
      const double judged = integral.of(path);
      EXPECT_GE(judged, bound) << name << ' ' << round;
      EXPECT_NEAR(judged,
                  oracle::sampled_cost(
                      grid, [&](Cell c) { return costs.weight(c); }, path, 4000),
                  2e-3 * judged)
          << name << ' ' << round;
      EXPECT_TRUE(i >= 3 || std::abs(cost - judged) <= 1e-9 * judged) << name << ' ' << round;
      EXPECT_TRUE(i >= 2 || std::abs(cost - moves.cost) <= 1e-9 * cost) << name << ' ' << round;
      dearer[i] += judged / ours.cost - 1;
      ++found;
    }
  }
  EXPECT_GT(found, 150);
  EXPECT_LT(missed, found / 10);
  // Any angle gains on eight moves.
  EXPECT_LT(dearer[2], dearer[0]);
  EXPECT_LT(dearer[3], 0.5 * dearer[0]);
}

}  // namespace
}  // namespace lasius::peers
