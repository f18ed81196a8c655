// The formulas of the papers with numbers worked by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/colony/update.h"
#include "lasius/params/schedule.h"
#include "lasius/plan/planner.h"
#include "tests/core/colony/walked_grid.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

// Fan, Luo, Yi, Zhang 2004.

TEST(Fan2004, ParametersAreThePapers) {
  const Params p("fan2004");
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
  const Params p("fan2004");
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
  const auto shares = schedule(Params("fan2004"), 0);
  EXPECT_EQ(shares.pheromone_rule, 0);
  EXPECT_EQ(shares.distance_rule, 1);
  EXPECT_EQ(shares.combined_rule, 0);
}

TEST(Fan2004, SharesOfTheRulesChangeUntilTheCriticalTimeAndSettle) {
  // a = 0.4: pheromone 0.01 a, distance 1 - 0.7 a, combined 0.7 a.
  const auto early = schedule(Params("fan2004"), 4);
  EXPECT_DOUBLE_EQ(early.pheromone_rule, 0.004);
  EXPECT_DOUBLE_EQ(early.distance_rule, 0.72);
  EXPECT_DOUBLE_EQ(early.combined_rule, 0.28);
  // From 10 to 70 the distance rule falls from 0.3 to 0.002: at 40 it is half way.
  EXPECT_DOUBLE_EQ(schedule(Params("fan2004"), 10).distance_rule, 0.3);
  const auto half = schedule(Params("fan2004"), 40);
  EXPECT_DOUBLE_EQ(half.distance_rule, 0.151);
  EXPECT_DOUBLE_EQ(half.combined_rule, 0.7);
  for (const int q : {70, 71, 119}) {
    const auto late = schedule(Params("fan2004"), q);
    EXPECT_DOUBLE_EQ(late.pheromone_rule, 0.01);
    EXPECT_DOUBLE_EQ(late.distance_rule, 0.002);
  }
}

TEST(Fan2004, DistanceRuleIsEquation4) {
  // Cell (3, 4), goal (6, 8): distances of the neighbours N (3,3), W (2,4), E (4,4), S (3,5) are
  // sqrt(34), sqrt(32), sqrt(20), sqrt(18); Dmax = sqrt(34).
  const Grid grid(20, 20);
  Rows rows(grid, {6, 8}, Params("fan2004"));
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
  Rows rows(grid, {6, 8}, Params("fan2004"));
  const float* phi = rows.of({3, 4}) + 4;
  EXPECT_EQ(phi[0], 0);
  EXPECT_NEAR(phi[1], 4 / std::pow((std::sqrt(32.0) - std::sqrt(18.0)) * 10 + 2, 2), 1e-6);
}

TEST(Fan2004, UpdateKeepsPersistenceAndAddsQOverL) {
  // tau0 = 1, persistence 0.7, two ants with Q / L = 0.25 and 0.5 on a cell: 0.7 + 0.75 = 1.45.
  const Grid grid(20, 20);
  Rows rows(grid, {6, 8}, Params("fan2004"));
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
  Params p("fan2004");
  p.ants = 1;
  p.iterations = 2;
  std::vector<double> tau;
  Planner(grid).plan({.start = {0, 0}, .goal = {4, 0}}, p,
                     {.observer = [&](const GridProgress& progress) {
                       if (progress.iteration > 0) return;
                       for (int x = 0; x < 5; ++x) tau.push_back(progress.pheromone({x, 0}));
                     }});
  ASSERT_EQ(tau.size(), 5u);
  for (const double t : tau) EXPECT_NEAR(t, 50.7, 1e-4);
}

// Dorigo, Maniezzo, Colorni 1996.

TEST(AntSystem, VisibilityIsOneOverTheDistanceToTheGoal) {
  const Grid grid(20, 20);
  Rows rows(grid, {10, 4}, Params("as", Preset::book));  // beta = 5
  const float* w = rows.of({3, 4});
  // E leads to distance 6, the largest weight; W to 8: (6 / 8)^5 = 0.2373.
  EXPECT_EQ(w[4], 1);
  EXPECT_NEAR(w[3], 0.237305, 1e-6);
  EXPECT_NEAR(w[2], std::pow(6 / std::sqrt(37.0), 5), 1e-6);  // NE: distance sqrt(36 + 1)
}

TEST(AntSystem, PheromoneLiesOnTheArcsWalked) {
  Grid grid(5, 1);
  Params p("as", Preset::book);
  p.ants = 1;
  p.iterations = 1;
  p.initial_pheromone = 1;
  double on_arc = 0, off = 0;
  Planner(grid).plan({.start = {0, 0}, .goal = {4, 0}}, p,
                     {.observer = [&](const GridProgress& progress) {
                       on_arc = progress.pheromone({0, 0});
                       off = progress.pheromone({4, 0});  // no arc leads on from the goal
                     }});
  EXPECT_NEAR(on_arc, 0.7 + 0.25, 1e-6);
  EXPECT_NEAR(off, 0.7, 1e-6);
}

TEST(Elitist, TheBestTourSoFarDepositsAgain) {
  // Evaporation 0.5, e = 30, Q = 1: 0.5 + 1/2 on the tour of length 2, and 30/2 more as the best.
  WalkedGrid trail(Params("eas", Preset::book));
  trail.walk({kEast, kEast});
  trail.walk({kNorthEast});
  trail.update(0);
  EXPECT_NEAR(trail.tau(2, 2, kEast), 0.5 + 0.5 + 15, 1e-5);
  EXPECT_NEAR(trail.tau(2, 2, kNorthEast), 0.5 + 1 / std::sqrt(2.0), 1e-6);
}

TEST(RankBased, WeightsFallWithTheRank) {
  // w = 3: rank 1 deposits 2/L, rank 2 1/L, rank 3 nothing, the best so far 3/L; evaporation 0.1.
  Params p("ras", Preset::book);
  p.ranks = 3;
  WalkedGrid trail(p);
  trail.walk({kEast, kEast, kEast, kEast});  // rank 3
  trail.walk({kNorthEast});                  // rank 1 and best so far
  trail.walk({kEast, kEast});                // rank 2
  trail.update(1);
  EXPECT_NEAR(trail.tau(2, 2, kNorthEast), 0.9 + 5 / std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(trail.tau(2, 2, kEast), 0.9 + 1.0 / 2, 1e-6);
  EXPECT_NEAR(trail.tau(5, 2, kEast), 0.9, 1e-6);
}

TEST(MaxMin, PheromoneStaysBetweenItsBounds) {
  // Best tour of 4 moves, L = 4, evaporation 0.02: tau_max = 1 / (0.02 * 4) = 12.5; p^(1/4) =
  // 0.05^0.25 = 0.472871, mean choice 4: tau_min = 12.5 * 0.527129 / (3 * 0.472871) = 4.644734.
  WalkedGrid trail(Params("mmas", Preset::book), 100);
  trail.walk({kEast, kEast, kEast, kEast});
  trail.update(0);
  EXPECT_NEAR(trail.tau(2, 2, kEast), 12.5, 1e-4);
  EXPECT_NEAR(trail.tau(2, 2, kNorthEast), 12.5, 1e-4);
  for (int i = 0; i < 200; ++i) trail.update(0);  // 12.5 * 0.98^200 = 0.22 without a bound
  EXPECT_NEAR(trail.tau(2, 2, kEast), 12.5, 1e-4);
  EXPECT_NEAR(trail.tau(2, 2, kNorthEast), 4.644734, 1e-4);
}

TEST(AntColonySystem, OnlyTheBestTourChangesGlobally) {
  // tau <- 0.9 * 1 + 0.1 * (1 / 2) = 0.95 on the best tour, 1 elsewhere.
  WalkedGrid trail(Params("acs", Preset::book));
  trail.walk({kEast, kEast});
  trail.walk({kNorthEast, kNorthEast, kNorthEast});
  trail.update(0);
  EXPECT_NEAR(trail.tau(3, 2, kEast), 0.95, 1e-6);
  EXPECT_NEAR(trail.tau(2, 2, kNorthEast), 1, 1e-6);
}

TEST(AntColonySystem, CrossedArcsReturnTowardTau0) {
  // xi = 0.1, tau0 = 0.2: tau <- 0.9 * 1 + 0.1 * 0.2 = 0.92.
  WalkedGrid trail(Params("acs", Preset::book));
  const std::vector<std::uint8_t> moves{kEast};
  const Tour tour{moves, 1};
  std::vector<int> ranking;
  update_locally(trail.rows.field, trail.params, 0.2,
                 {.start = {2, 2},
                  .moves = trail.rows.moves,
                  .ants = {&tour, 1},
                  .best_so_far = tour,
                  .ranking = ranking},
                 {});
  EXPECT_NEAR(trail.tau(2, 2, kEast), 0.92, 1e-6);
  EXPECT_NEAR(trail.tau(3, 2, kEast), 1, 1e-6);
}

TEST(LectureGrid, TheBestAntsShareTheDeposit) {
  // Evaporation 0.1, tau0 0.5, Q = 0.5, 3 ants of which 2 deposit: 0.45 + 0.5 / 3.
  Params p("lecture-grid");
  p.elite_ants = 2;
  WalkedGrid trail(p, 0.5);
  trail.walk({kEast, kEast});
  trail.walk({kEast, kEast, kEast, kEast});
  trail.walk({kNorthEast});
  trail.update(2);
  EXPECT_NEAR(trail.tau(3, 1), 0.45 + 0.5 / 3, 1e-6);
  EXPECT_NEAR(trail.tau(3, 2), 0.45 + 0.5 / 3, 1e-6);
  EXPECT_NEAR(trail.tau(2, 2), 0.45 + 2 * 0.5 / 3, 1e-6);
  EXPECT_NEAR(trail.tau(6, 2), 0.45, 1e-6);
}

TEST(LectureGrid, EndsWhenAllAntsTakeOnePath) {
  const Planner corridor(Grid(9, 1)), hall(Grid(9, 9));
  Params params("lecture-grid");
  const auto iterations = [&](const Planner& planner) {
    const Result found = planner.plan({.start = {0, 0}, .goal = {8, 0}}, params);
    EXPECT_EQ(found.status, Status::solved);
    return found.curves.iterations;
  };
  EXPECT_EQ(iterations(corridor), 1);
  EXPECT_EQ(iterations(hall), 50);
  params.agreement = 3;
  EXPECT_EQ(iterations(corridor), 3);
  params.ants = 1;  // alone
  EXPECT_EQ(iterations(corridor), 50);
  params.ants = 20;
  params.agreement = 0;
  EXPECT_EQ(iterations(corridor), 50);
}

// Cong, Ponnambalam 2009. Four neighbours: north, west, east, south.

TEST(Cong2009, SuccessMultipliesPheromoneAndTeachesTheHeuristic) {
  // tau <- 0.8 * 3 = 2.4, then * (1 + 1.2 * 20 / 4) = 16.8; eta <- 1 + 20 / 4 = 6.
  WalkedGrid trail(Params("cong2009"), 3);
  trail.walk({2, 2, 2, 2});
  trail.update(0);
  EXPECT_NEAR(trail.tau(4, 2), 16.8, 1e-5);
  EXPECT_NEAR(trail.rows.field.eta({4, 2}), 6, 1e-6);
  EXPECT_NEAR(trail.tau(4, 5), 2.4, 1e-6);
  EXPECT_NEAR(trail.rows.field.eta({4, 5}), 1, 1e-6);
}

// The text's example, figures 1 to 4: 5 x 5 cells, a tour of distance 8. Step 9: first evaporation,
// 0.8 * 3 = 2.4; then equation 3, read as 2.4 (1 + 1.2 * 5 / 8) = 4.2 or as 2.4 * 1.2 * 5 / 8 + 1 =
// 2.8, and equation 4, 1 + 5 / 8 = 1.625. Other cells keep 2.4 and 1.
TEST(Cong2009, EightMovesOn5x5ByEitherReadingOfEquation3) {
  for (const auto& [reading, taught] : {std::pair{Reward::factor, 4.2}, {Reward::affine, 2.8}}) {
    Params params("cong2009");
    params.reward_reading = reading;
    WalkedGrid trail(params, 3, 5, {0, 4}, {4, 0});
    trail.walk({2, 2, 2, 2, 0, 0, 0, 0});
    trail.update();
    for (const Cell c : cells_of(trail.grid)) {
      const bool on_tour = c.y == 4 || c.x == 4;
      EXPECT_NEAR(trail.tau(c.x, c.y), on_tour ? taught : 2.4, 1e-6) << c.x << "," << c.y;
      EXPECT_NEAR(trail.rows.field.eta(c), on_tour ? 1.625 : 1, 1e-6) << c.x << "," << c.y;
    }
  }
}

TEST(Cong2009, ADeadEndHalvesTheSecondHalfOfTheTour) {
  WalkedGrid trail(Params("cong2009"), 3);
  trail.walk({2, 2, 2, 2}, false);
  trail.update();
  EXPECT_NEAR(trail.tau(3, 2), 2.4, 1e-6);
  for (int x = 4; x <= 6; ++x) {
    EXPECT_NEAR(trail.tau(x, 2), 1.2, 1e-6) << x;
    EXPECT_NEAR(trail.rows.field.eta({x, 2}), 0.5, 1e-6) << x;
  }
}

}  // namespace
}  // namespace lasius
