// What the colony does with its rules, its paths and its best tour, as an observer sees it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/colony/terminal_index.h"
#include "core/colony/update.h"
#include "core/grid/move_rule.h"
#include "lasius/path/path.h"
#include "tests/core/grid/centres.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

/// tau on a corridor of 5 cells after each iteration: every tour is the corridor, L = 4.
std::vector<double> corridor(Params params, int iterations) {
  params.iterations = iterations;
  std::vector<double> tau;
  Planner(Grid(5, 1))
      .plan({.start = {0, 0}, .goal = {4, 0}}, params, {.observer = [&](const GridProgress& seen) {
              tau.push_back(seen.pheromone({1, 0}));
              EXPECT_EQ(seen.pheromone({2, 0}), tau.back());
            }});
  return tau;
}

TEST(Colony, UpdatesLocallyAfterEachAnt) {
  // xi = 0.1, persistence 0.9, Q = 1. The first ants find tau0; 0.9 * 0.01 + 0.1 / 4 = 0.034. Then
  // 0.9 * 0.034 + 0.1 * 0.01 = 0.0316 and 0.9 * 0.0316 + 0.001 = 0.02944, and 0.9 * 0.02944 +
  // 0.025.
  Params params("acs", Preset::book);
  params.ants = 2;
  params.initial_pheromone = 0.01;
  const auto tau = corridor(params, 2);
  ASSERT_EQ(tau.size(), 2u);
  EXPECT_NEAR(tau[0], 0.034, 1e-7);
  EXPECT_NEAR(tau[1], 0.051496, 1e-7);
}

TEST(Colony, APointsKnightPassesBetweenTwoBlockedCells) {
  Params params = quick("acs");
  params.neighbours = Neighbours::sixteen_knight;
  params.polish = Polish::none;
  const Planner planner(drawn({"..#", "#.."}));
  EXPECT_DOUBLE_EQ(planner.plan({.start = {0, 0}, .goal = {2, 1}}, params).length, std::sqrt(5.0));
}

TEST(Colony, LaterBatchesWalkByWhatEarlierOnesLeft) {
  const FarApart far;
  Params params = quick("acs");
  const Result one_by_one = far.plan(params);
  params.batch = 0;
  const Result at_once = far.plan(params);
  EXPECT_EQ(one_by_one.curves.mean.front(), at_once.curves.mean.front())
      << "all tau0, whoever walked";
  EXPECT_NE(one_by_one.curves.mean, at_once.curves.mean);
}

TEST(Colony, LaysStraightenedPathsAsAsked) {
  // Q / L = 25, persistence 0.7: the tour each time, its path where it is asked for. The first path
  // improves on none, the second is as long.
  Params params("fan2004");
  params.ants = 1;
  const auto expect = [&](StraightDeposit which, double first, double second) {
    params.straight_deposit = which;
    const auto tau = corridor(params, 2);
    ASSERT_EQ(tau.size(), 2u);
    EXPECT_NEAR(tau[0], first, 1e-4);
    EXPECT_NEAR(tau[1], second, 1e-4);
  };
  expect(StraightDeposit::none, 0.7 + 25, 0.7 * 25.7 + 25);
  expect(StraightDeposit::improving, 0.7 + 50, 0.7 * 50.7 + 25);
  expect(StraightDeposit::all, 0.7 + 50, 0.7 * 50.7 + 50);
}

/// The best so far is the least of what the iterations offered.
void expect_best_of_iterations(const Result& found) {
  ASSERT_EQ(found.curves.iteration_best.size(), found.curves.best.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found.curves.best.size(); ++i) {
    least = std::fmin(least, found.curves.iteration_best[i]);
    EXPECT_NEAR(found.curves.best[i], least, 1e-9 * least) << i;
  }
}

// The answer of the terminal index joins what several ants know, rather than be one ant's tour.
TEST(Colony, OffersTheBestWayThatItsAntsKnowTogether) {
  const FarApart far;
  double shortest_tour = std::numeric_limits<double>::infinity();
  int joined = 0;
  const auto look = [&](const GridProgress& seen) {
    for (int a = 0; a < seen.ants(); ++a) {
      shortest_tour = std::min(shortest_tour, path_length(centres(seen.tour(a))));
    }
    EXPECT_LE(seen.best_length, seen.pheromone(far.request.start) * (1 + 1e-6));
    joined += seen.best_length < 0.99 * shortest_tour ? 1 : 0;
  };
  const Result found = far.plan(quick("terminal-index"), {.observer = look});
  EXPECT_GT(joined, 5);
  expect_best_of_iterations(found);
  EXPECT_LT(found.curves.iteration_best.front(),
            found.curves.raw_best.front());  // an answer, no ant's tour
}

TEST(Colony, RecordsWhatEachIterationOffered) {
  const FarApart far;
  for (const Polish polish : {Polish::none, Polish::straight}) {
    Params params = quick("lecture-grid");
    params.polish = polish;
    const Result found = far.plan(params);
    expect_best_of_iterations(found);
    if (polish == Polish::none) {
      EXPECT_EQ(found.curves.iteration_best, found.curves.cut_best);
      EXPECT_FALSE(std::ranges::is_sorted(found.curves.iteration_best, std::greater()));
    } else {
      EXPECT_LT(found.curves.iteration_best.back(), found.curves.cut_best.back());
    }
  }
}

TEST(Colony, TheBandIsCountedAlongTheRawTour) {
  // From (0, 0) to (20, 0) a tenth of the distance is 2 rows. A wall to row 3 at column 10: the way
  // to the gap and back has cells in rows 3 and 4, and those above them in the band.
  Grid grid(21, 5);
  for (int y = 0; y < 4; ++y) grid.set_blocked({10, y});
  Params params("as");
  params.iterations = 3;
  const Request request{.start = {0, 0}, .goal = {20, 0}};
  std::vector<double> shares;
  const Result result =
      Planner(grid).plan(request, params, {.observer = [&](const GridProgress& progress) {
                           double near = 0, all = 0;
                           for (int ant = 0; ant < progress.ants(); ++ant) {
                             for (const Cell c : progress.tour(ant)) {
                               near += c.y <= 2;
                               ++all;
                             }
                           }
                           shares.push_back(near / all);
                           EXPECT_EQ(progress.curves->band.back(), shares.back());
                         }});
  EXPECT_EQ(result.curves.band, shares);
  EXPECT_LT(shares.front(), 1);
  EXPECT_GT(shares.front(), 0);
}

TEST(TrailEntropy, IsThatOfTheMovesAlongTheTour) {
  // One move of a tour from a cell with two ways: tau 3 and 1 make 2 - 0.75 log2 3 = 0.811278 bits.
  Grid grid(3, 2);
  grid.set_blocked({2, 1});
  Params params("as", Preset::book);
  params.neighbours = Neighbours::four;
  const kernels::Moves moves = moves_of(Neighbours::four);
  Field field;
  field.reset(grid, moves, {2, 0}, params, 1, {});
  std::uint8_t east = 0;
  while (moves[east].to.dx != 1) ++east;
  const std::vector<std::uint8_t> tour{east};
  EXPECT_EQ(trail_entropy(field, Trail::arcs, moves, {0, 0}, tour), 1);
  field.set_tau({0, 0}, east, 3);
  EXPECT_NEAR(trail_entropy(field, Trail::arcs, moves, {0, 0}, tour), 0.811278, 1e-6);
  EXPECT_TRUE(std::isnan(trail_entropy(field, Trail::arcs, moves, {0, 0}, {})));
}

/// An index that ants teach, and its answer from (2, 2) to (6, 2).
class BestKnownWay : public testing::Test {
 protected:
  using Moves = std::vector<std::uint8_t>;
  static constexpr std::uint8_t kNorth = 1, kNorthEast = 2, kWest = 3, kEast = 4, kSouth = 6,
                                kSouthEast = 7;

  BestKnownWay() { field_.reset(grid_, moves_, kGoal, params_, 99, {}); }

  void teach(const Moves& walked, Cell start = kStart) {
    std::vector<int> ranking;
    const Tour tour{walked, 1};
    update_trail(field_, params_,
                 {.start = start,
                  .moves = moves_,
                  .ants = {&tour, 1},
                  .best_so_far = tour,
                  .rows = 20,
                  .ranking = ranking});
  }
  Moves answer(IndexAnswer reading) {
    Moves way{kEast};
    best_known_way(field_, moves_, kStart, kGoal, reading, way);
    return way;
  }

 private:
  static constexpr Cell kStart{2, 2}, kGoal{6, 2};
  const Grid grid_{20, 20};
  const Params params_{"terminal-index"};
  const kernels::Moves moves_ = moves_of(Neighbours::eight);
  Field field_;
};

TEST_F(BestKnownWay, FollowsTheLeastIndex) {
  EXPECT_EQ(answer(IndexAnswer::least_way), Moves());
  // Two tours that meet at (4, 1): one is short before it, one behind it.
  teach({kEast, kNorthEast, kNorthEast, kSouthEast, kSouth});
  teach({kNorth, kNorthEast, kEast, kSouth, kSouthEast, kEast});
  EXPECT_EQ(answer(IndexAnswer::least_way), (Moves{kEast, kNorthEast, kSouthEast, kEast}));
}

// K is 8.24 at the start. To the east, (3, 2), it is 4.41, 3.83 less at a step of 1; to the south
// east, (3, 3), it is 3.41, 4.83 less at 1.41: 3.41 a unit of length, but 4.83 in all, not 5.41.
TEST_F(BestKnownWay, HasTwoReadingsOfTheLargestGradient) {
  teach({kWest, kSouthEast, kSouthEast, kEast, kEast, kNorthEast, kNorth});
  teach({kSouth, kEast, kEast, kNorthEast}, {3, 2});
  EXPECT_EQ(answer(IndexAnswer::least_way), (Moves{kSouthEast, kEast, kEast, kNorthEast}));
  EXPECT_EQ(answer(IndexAnswer::steepest), (Moves{kEast, kSouthEast, kEast, kNorthEast}));
}

}  // namespace
}  // namespace lasius
