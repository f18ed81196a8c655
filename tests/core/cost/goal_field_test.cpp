// Walks that are kept while the weights change, against a search from scratch.
#include "core/cost/goal_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/cost/eight_moves.h"
#include "lasius/base/stop.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/weights.h"

namespace lasius::cost {
namespace {

double cost_of_walk(const Terrain& terrain, std::span<const Cell> walk) {
  double sum = 0;
  for (std::size_t i = 1; i < walk.size(); ++i) sum += terrain.move_cost(walk[i - 1], walk[i]);
  return sum;
}

TEST(GoalField, KeepsUpWithEditsAndMoves) {
  std::mt19937 random(5);
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  int walks = 0, apart = 0;
  for (int world = 0; world < 400; ++world) {
    auto [grid, costs, robot, goal] = random_weights(random, 3, 40);
    Terrain terrain(grid, costs);
    const Corners rule = world % 2 == 0 ? Corners::forbid : Corners::allow;
    GoalField field(terrain, goal, 0.01, rule == Corners::allow);
    for (int edit = 0; edit < 20; ++edit) {
      Poller poller(kNeverStops), other(kNeverStops);
      ASSERT_TRUE(field.update(robot, poller));
      const auto walk = field.walk();
      const auto best = EightMoves().search(terrain, robot, goal, rule, other, false);
      ASSERT_EQ(walk.empty(), best.empty()) << world << ' ' << edit;
      ++(walk.empty() ? apart : walks);
      if (!walk.empty()) {
        const double least = cost_of_walk(terrain, best);
        EXPECT_NEAR(cost_of_walk(terrain, walk), least, 1e-12 * least);
        EXPECT_EQ(walk.front(), robot);
        EXPECT_EQ(walk.back(), goal);
        robot = walk[std::min<std::size_t>(below(4), walk.size() - 1)];
      }
      std::vector<Cell> cells;
      for (int n = below(12); n >= 0; --n) {
        const Cell c{below(grid.width()), below(grid.height())};
        if (c == robot || c == goal) continue;
        terrain.set(c, below(3) == 0 ? kInfinity : 0.01 + 0.01 * below(900));
        cells.push_back(c);
      }
      field.changed(cells);
    }
  }
  EXPECT_GT(walks, 1000);
  EXPECT_GT(apart, 100);
}

// From (0, 0) the upper door is hardly worse than the middle one, and waits; after a long move,
// once that is closed, it is better than the lower one.
TEST(GoalField, GoesByADoorThatWaitedOnceAnotherCloses) {
  Grid grid(71, 61);
  grid.fill({60, 0, 1, 61}, true);
  Terrain terrain(grid, CostField(71, 61));
  const Cell middle{60, 30};
  terrain.set({60, 0}, 1);
  terrain.set(middle, 12.2);
  terrain.set({60, 60}, 3);
  GoalField field(terrain, {70, 30}, 1, true);
  Poller poller(kNeverStops);
  ASSERT_TRUE(field.update({0, 0}, poller));
  terrain.set(middle, kInfinity);
  field.changed({&middle, 1});
  ASSERT_TRUE(field.update({30, 30}, poller));
  EXPECT_NEAR(cost_of_walk(terrain, field.walk()), 20 + 40 * std::sqrt(2), 1e-9);
}

TEST(GoalField, GoesOnWhereItWasStopped) {
  const Grid grid(300, 300);
  const Terrain terrain(grid, CostField(300, 300));
  GoalField field(terrain, {0, 150}, 1, false);
  const StopCondition stopped = fired();
  int cuts = 0;
  for (;; ++cuts) {
    Poller poller(stopped, 64);
    if (field.update({299, 150}, poller)) break;
  }
  EXPECT_GT(cuts, 5);
  EXPECT_EQ(field.walk().size(), 300u);
}

}  // namespace
}  // namespace lasius::cost
