// Planning over costs from outside: what is refused, uniform weights, stops, observers.
#include "lasius/cost_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "lasius/error.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

CostField striped(const Grid& grid) {
  CostField costs(grid.width(), grid.height());
  std::vector<double> values;
  for (const Cell c : cells_of(grid)) values.push_back((c.x / 3 + c.y / 5) % 4);
  costs.add(values, 0.5);
  return costs;
}

TEST(CostPlanner, UniformWeightsGiveThePlanOfExact) {
  std::mt19937 random(3);
  for (const double weight : {1.0, 2.5}) {
    for (int i = 0; i < 20; ++i) {
      const Grid grid = random_grid(30, 20, 20, random);
      const std::vector<double> weights(600, weight);
      const Planner planner{Grid(grid)};
      const CostPlanner over(planner, CostField(30, 20, weights));
      const Request request{.start = *planner.nearest_free({1, 1}),
                            .goal = *planner.nearest_free({28, 17})};
      const Result plain = planner.plan(request);
      const CostResult result = over.plan(request);
      EXPECT_EQ(result.path, plain.path);
      EXPECT_EQ(result.status, plain.status);
      if (plain.path.empty()) continue;
      EXPECT_EQ(result.length, plain.length);
      EXPECT_EQ(result.cost, weight * plain.length);
      EXPECT_TRUE(result.optimal);
      EXPECT_EQ(result.gap(), 0);
    }
  }
}

TEST(CostPlanner, AnswersAsPlannersDo) {
  const Grid grid = drawn({"......#..",  //
                           ".####.#..",  //
                           ".....##..",  //
                           "......#.."});
  const CostPlanner planner(Planner(Grid(grid)), striped(grid));
  EXPECT_EQ(planner.plan({.start = {6, 0}, .goal = {0, 0}}).fault, Fault::start_blocked);
  EXPECT_EQ(planner.plan({.start = {0, 0}, .goal = {9, 0}}).fault, Fault::goal_outside);
  EXPECT_EQ(planner.plan({.start = {0, 0}, .goal = {8, 0}}).status, Status::unreachable);
  const CostResult same = planner.plan({.start = {2, 2}, .goal = {2, 2}});
  EXPECT_EQ(same.cost, 0);
  EXPECT_EQ(same.path.size(), 1);
  EXPECT_EQ(same.gap(), 0);
  const CostResult near = planner.plan({.start = {0, 0}, .goal = {8, 3}, .goal_tolerance = 3.5});
  ASSERT_TRUE(near.goal_reached);
  EXPECT_EQ(near.path.back(), centre(*near.goal_reached));
  const CostResult result = planner.plan({.start = {5, 0}, .goal = {5, 3}});
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_NEAR(result.cost, *path_cost(grid, striped(grid), result.path), 1e-9);
  EXPECT_GT(*result.lower_bound, 0.99 * result.cost);
  const CostResult walk =
      planner.plan({.start = {5, 0}, .goal = {5, 3}}, CostOptions{.eight_moves = true});
  EXPECT_GE(walk.cost, result.cost);
  EXPECT_TRUE(walk.optimal);
  EXPECT_THROW(CostPlanner(Planner(Grid(grid)), CostField(9, 5)), Error);
  EXPECT_THROW(CostPlanner(Planner(Grid(grid), Disc{60}), CostField(9, 4)), Error);
  const CostPlanner disc(Planner(Grid(grid), Disc{0.5}), striped(grid));
  EXPECT_THROW((void)disc.plan({.start = {0, 0}, .goal = {8, 3}}, {.eight_moves = true}), Error);
  EXPECT_THROW((void)disc.plan({.start = {0, 0}, .goal = {8, 3}}, {.proof = true}), Error);
}

TEST(CostPlanner, ObserversSeeCheaperPathsAndEndTheSearch) {
  const Grid grid(60, 60);
  const CostField costs = striped(grid);
  const CostPlanner planner(Planner(Grid(grid)), costs);
  double last = 1e300;
  int calls = 0;
  const CostResult whole =
      planner.plan({.start = {2, 3}, .goal = {55, 50}}, {}, [&](const GridProgress& progress) {
        EXPECT_LT(progress.best_length, last);
        EXPECT_NEAR(progress.best_length, *path_cost(grid, costs, progress.path()), 1e-9);
        EXPECT_EQ(progress.iteration, calls++);
        last = progress.best_length;
      });
  EXPECT_GE(calls, 2);
  EXPECT_EQ(whole.cost, last);
  const CostResult again = planner.plan({.start = {2, 3}, .goal = {55, 50}});
  EXPECT_EQ(again.path, whole.path);
  EXPECT_EQ(again.lower_bound, whole.lower_bound);
  const CostResult cut = planner.plan({.start = {2, 3}, .goal = {55, 50}}, {},
                                      [](const GridProgress& progress) { progress.stop(); });
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_GT(cut.cost, whole.cost);
}

}  // namespace
}  // namespace lasius
