// The formulas of the papers with numbers worked by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "field.h"
#include "lasius/planner.h"
#include "schedule.h"

namespace lasius {
namespace {

// Fan, Luo, Yi, Zhang 2004.

TEST(Fan2004, ParametersAreThePapers) {
  const Params p = defaults("fan2004");
  EXPECT_EQ(p.ants, 10);
  EXPECT_EQ(p.critical_time, 10);
  EXPECT_EQ(p.iterations, 120);
  EXPECT_EQ(p.persistence, 0.7);
  EXPECT_EQ(p.neighbours, Neighbours::four);
  EXPECT_EQ(p.omega, 10);
  EXPECT_EQ(p.mu, 2);
  EXPECT_EQ(p.lambda, 2);
}

TEST(Fan2004, ExponentsFollowEquations5And6) {
  const Params p = defaults("fan2004");
  // q = 5, mc = 10: alpha = 4 * 5 / 10 = 2, beta = (3 * 10 - 1.5 * 5) / 10 = 2.25.
  EXPECT_DOUBLE_EQ(schedule(p, 0).alpha, 0);
  EXPECT_DOUBLE_EQ(schedule(p, 0).beta, 3);
  EXPECT_DOUBLE_EQ(schedule(p, 5).alpha, 2);
  EXPECT_DOUBLE_EQ(schedule(p, 5).beta, 2.25);
  for (const int q : {10, 11, 119}) {
    EXPECT_EQ(schedule(p, q).alpha, 4) << q;
    EXPECT_EQ(schedule(p, q).beta, 1.5) << q;
  }
}

TEST(Fan2004, TheFirstGenerationUsesDistanceAlone) {
  const auto shares = schedule(defaults("fan2004"), 0).rule_shares;
  EXPECT_EQ(shares[kernels::kPheromoneRule], 0);
  EXPECT_EQ(shares[kernels::kDistanceRule], 1);
  EXPECT_EQ(shares[kernels::kCombinedRule], 0);
}

TEST(Fan2004, SharesOfTheRulesChangeUntilTheCriticalTime) {
  // a = 0.4: pheromone 0.1 a, distance 1 - 0.9 a, combined 0.8 a.
  const auto shares = schedule(defaults("fan2004"), 4).rule_shares;
  EXPECT_DOUBLE_EQ(shares[kernels::kPheromoneRule], 0.04);
  EXPECT_DOUBLE_EQ(shares[kernels::kDistanceRule], 0.64);
  EXPECT_DOUBLE_EQ(shares[kernels::kCombinedRule], 0.32);
}

struct Rows {
  Rows(const Grid& grid, Cell goal, const Params& p) : params(p) {
    moves = kernels::moves_of(static_cast<kernels::Neighbourhood>(p.neighbours));
    field.reset(grid, moves, goal, p, p.initial_pheromone > 0 ? p.initial_pheromone : 1, {});
  }
  const float* of(Cell c) {
    kernels::WalkWorld world;
    field.fill(world);
    const int tile = (c.y / 32) * world.tiles_x + c.x / 32;
    const float* rows = world.tiles[tile];
    if (rows == nullptr) rows = world.make_tile(world.context, tile);
    return rows + ((c.y % 32) * 32 + c.x % 32) * moves.count * (field.mixture() ? 2 : 1);
  }
  Params params;
  kernels::Moves moves;
  Field field;
};

TEST(Fan2004, DistanceRuleIsEquation4) {
  // Cell (3, 4), goal (6, 8): distances of the neighbours N (3,3), W (2,4), E (4,4), S (3,5) are
  // sqrt(34), sqrt(32), sqrt(20), sqrt(18); Dmax = sqrt(34).
  const Grid grid(20, 20);
  Rows rows(grid, {6, 8}, defaults("fan2004"));
  const float* phi = rows.of({3, 4}) + 4;
  const auto value = [](double d) { return std::pow((std::sqrt(34.0) - d) * 10 + 2, 2); };
  const double south = value(std::sqrt(18.0));  // 17.883^2, the largest
  EXPECT_NEAR(south, 319.806, 0.001);
  EXPECT_NEAR(phi[0], 4 / south, 1e-6);  // mu^lambda = 4 for the farthest
  EXPECT_NEAR(phi[1], value(std::sqrt(32.0)) / south, 1e-6);
  EXPECT_NEAR(phi[2], value(std::sqrt(20.0)) / south, 1e-6);
  EXPECT_EQ(phi[3], 1);
}

TEST(Fan2004, DistanceRuleTakesDmaxOverFreeCellsOnly) {
  Grid grid(20, 20);
  grid.set_blocked({3, 3});  // the farthest neighbour: W becomes Dmax
  Rows rows(grid, {6, 8}, defaults("fan2004"));
  const float* phi = rows.of({3, 4}) + 4;
  EXPECT_EQ(phi[0], 0);
  EXPECT_NEAR(phi[1], 4 / std::pow((std::sqrt(32.0) - std::sqrt(18.0)) * 10 + 2, 2), 1e-6);
}

TEST(Fan2004, UpdateKeepsPersistenceAndAddsQOverL) {
  // tau0 = 1, persistence 0.7, two ants with Q / L = 0.25 and 0.5 on a cell: 0.7 + 0.75 = 1.45.
  const Grid grid(20, 20);
  Rows rows(grid, {6, 8}, defaults("fan2004"));
  rows.field.evaporate(0.7);
  rows.field.deposit({4, 4}, 0, 0.25);
  rows.field.deposit({4, 4}, 0, 0.5);
  EXPECT_NEAR(rows.field.pheromone({4, 4}), 1.45, 1e-6);
  EXPECT_NEAR(rows.field.pheromone({5, 4}), 0.7, 1e-6);
  // Equation 1 at (3, 4) with alpha = 4: E against the others is (1.45 / 0.7)^4 : 1 = 18.41.
  rows.field.refresh(schedule(rows.params, 50), 1);
  const float* a = rows.of({3, 4});
  EXPECT_EQ(a[2], 1);
  EXPECT_NEAR(a[0], 1 / 18.411, 1e-5);
  EXPECT_EQ(a[0], a[1]);
  EXPECT_EQ(a[0], a[3]);
}

TEST(Fan2004, DepositsItsTourAndItsStraightenedPath) {
  // One ant in a corridor of 5 cells: its tour and straightened path are the corridor, L = 4, so
  // after one iteration tau = 0.7 * 1 + 100 / 4 + 100 / 4 on each cell.
  Grid grid(5, 1);
  Params p = defaults("fan2004");
  p.ants = 1;
  p.iterations = 2;
  std::vector<double> tau;
  Planner(grid).plan({.start = {0, 0}, .goal = {4, 0}}, p, nullptr, [&](const Progress& progress) {
    if (progress.iteration > 0) return;
    for (int x = 0; x < 5; ++x) tau.push_back(progress.pheromone({x, 0}));
  });
  ASSERT_EQ(tau.size(), 5u);
  for (const double t : tau) EXPECT_NEAR(t, 50.7, 1e-4);
}

// Dorigo, Maniezzo, Colorni 1996.

TEST(AntSystem, VisibilityIsOneOverTheDistanceToTheGoal) {
  const Grid grid(20, 20);
  Rows rows(grid, {10, 4}, defaults("as"));  // beta = 5
  const float* w = rows.of({3, 4});
  // E leads to distance 6, the largest weight; W to 8: (6 / 8)^5 = 0.2373.
  EXPECT_EQ(w[4], 1);
  EXPECT_NEAR(w[3], 0.237305, 1e-6);
  EXPECT_NEAR(w[2], std::pow(6 / std::sqrt(37.0), 5), 1e-6);  // NE: distance sqrt(36 + 1)
}

TEST(AntSystem, PheromoneLiesOnTheArcsWalked) {
  Grid grid(5, 1);
  Params p = defaults("as");
  p.ants = 1;
  p.iterations = 1;
  p.initial_pheromone = 1;
  double on_arc = 0, off = 0;
  Planner(grid).plan({.start = {0, 0}, .goal = {4, 0}}, p, nullptr, [&](const Progress& progress) {
    on_arc = progress.pheromone({0, 0});
    off = progress.pheromone({4, 0});  // no arc leads on from the goal
  });
  EXPECT_NEAR(on_arc, 0.7 + 0.25, 1e-6);
  EXPECT_NEAR(off, 0.7, 1e-6);
}

}  // namespace
}  // namespace lasius
