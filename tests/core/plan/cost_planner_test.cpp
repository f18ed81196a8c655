// Planning over costs from outside: what is refused, uniform weights, stops, observers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/plan/disc_path.h"
#include "lasius/base/error.h"
#include "lasius/cost/planner.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/weights.h"

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

/// What is wrong with an answer for a disc, or nothing.
std::string fault_of(const CostPlanner& planner, const CostField& costs, const CostResult& result) {
  const Grid& grid = planner.planner().grid();
  const double radius = planner.planner().robot().radius;
  if (const auto fault = disc_path_fault(grid, radius, result.path, {})) return *fault;
  const auto cost = path_cost(grid, costs, result.path);
  if (!cost || std::abs(*cost - result.cost) > 1e-9 * result.cost) return "it has another cost";
  if (std::abs(path_length(result.path) - result.length) > 1e-9) return "it has another length";
  return *result.lower_bound <= result.cost ? "" : "its bound is above its cost";
}

TEST(CostPlanner, ADiscKeepsItsRadius) {
  std::mt19937 random(8);
  int solved = 0;
  double gaps = 0;
  for (int i = 0; i < 60; ++i) {
    const double radius = std::array{0.3, 0.5, 0.8, 1.0, 2.2}[i % 5];
    const Grid grid = random_grid(50, 40, i % 5 < 3 ? 8 : 2, random);
    CostField costs = striped(grid);
    costs.add(grid, {.radius = 6, .scaling = 0.6, .weight = 3, .inscribed = radius});
    const CostPlanner planner(Planner(Grid(grid), Disc{radius}), costs);
    const Request request{.start = *planner.planner().nearest_free({2, 3}),
                          .goal = *planner.planner().nearest_free({45, 36})};
    double seen = kInfinity;
    const CostResult result =
        planner.plan(request, {.observer = [&](const GridProgress& progress) {
                       EXPECT_LT(progress.best_length, seen);
                       EXPECT_FALSE(disc_path_fault(grid, radius, progress.path(), {}));
                       seen = progress.best_length;
                     }});
    if (result.status == Status::unreachable) continue;
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_EQ(fault_of(planner, costs, result), "") << i;
    EXPECT_EQ(result.cost, seen);
    EXPECT_EQ(planner.plan(request).path, result.path);
    // Nothing that a point may do is cheaper than a bound for the point says.
    const CostPlanner point(Planner(Grid(grid)), costs);
    EXPECT_LE(*point.plan(request).lower_bound, result.cost);
    gaps += *result.gap();
    ++solved;
  }
  EXPECT_GT(solved, 40);
  EXPECT_LT(gaps / solved, 0.05);
}

// A corridor with a step that cells pass and the disc does not: the second search is cut, too.
TEST(CostPlanner, ADiscIsCutAnywhere) {
  Grid grid(300, 300);
  grid.fill({140, 4, 20, 296}, true);
  grid.fill({140, 150, 10, 2}, false);
  grid.fill({150, 151, 10, 2}, false);
  std::mt19937 random(5);
  CostField costs(300, 300);
  std::vector<double> values(std::size_t{300} * 300);
  for (double& value : values) value = random_in(0, 59, random);
  costs.add(values);
  const CostPlanner planner(Planner(grid, Disc{0.9}), costs);
  Request request{.start = {138, 150}, .goal = {162, 151}};
  const CountingTime counted(1 << 30);
  request.stop = counted.is_up();
  ASSERT_EQ(planner.plan(request).status, Status::solved);
  ASSERT_GT(counted.polls(), 20);
  for (int i = 0; i < 20; ++i) {
    const CountingTime time(counted.polls() * i / 20);
    request.stop = time.is_up();
    const CostResult cut = planner.plan(request);
    if (!cut.path.empty()) {
      EXPECT_FALSE(disc_path_fault(grid, 0.9, cut.path, {})) << i;
    }
  }
}

TEST(CostPlanner, AProofChangesNoAnswer) {
  std::mt19937 random(43);
  int proofs = 0;
  for (int i = 0; i < 40; ++i) {
    const Grid grid = random_grid(14, 9, 15, random);
    const CostField costs = i % 4 == 0 ? CostField(14, 9) : striped(grid);
    const CostPlanner planner(Planner(Grid(grid)), costs);
    const auto place = [&](int side) {
      return std::array{0.3, 0.5, 1.0, 0.9}[random() % 4] + static_cast<double>(random() % side);
    };
    Request request{.start_point = Point{place(14), place(9)},
                    .goal_point = Point{place(14), place(9)}};
    if (i % 3 == 0) request.goal_tolerance = 2;
    const CostResult plain = planner.plan(request);
    const CostResult proven = planner.plan(request, {.proof = true});
    EXPECT_EQ(proven.status, plain.status);
    EXPECT_EQ(proven.path, plain.path) << i;
    if (plain.path.empty()) continue;
    EXPECT_EQ(proven.cost, plain.cost);
    EXPECT_EQ(proven.lower_bound, plain.lower_bound);
    ASSERT_TRUE(proven.proof) << i;
    EXPECT_EQ(check_proof(grid, costs, *proven.proof), std::nullopt) << i;
    ++proofs;
  }
  EXPECT_GT(proofs, 20);
}

// A corner's arc passes between two points of one cell.
TEST(CostPlanner, ADiscGoesRoundWithinACell) {
  Grid grid(20, 20);
  grid.fill({0, 0, 10, 10}, true);
  const Planner disc(std::move(grid), Disc{2});
  std::vector<double> dearer_elsewhere(400, 0);
  dearer_elsewhere.back() = 1;
  CostField costs(20, 20);
  costs.add(dearer_elsewhere);
  const Request request{.start_point = Point{11.001, 11.7325},
                        .goal_point = Point{11.7325, 11.001}};
  const CostResult result = CostPlanner(Planner(disc), costs).plan(request);
  ASSERT_EQ(result.status, Status::solved) << result.error;
  EXPECT_GE(result.cost, disc.plan(request).length * (1 - 1e-9));
  EXPECT_NEAR(result.cost, result.length, 1e-9);
}

TEST(CostPlanner, ADiscIsLedOut) {
  const Grid grid = drawn({".........", ".........", "....#....", ".........", "........."});
  const CostField costs = striped(grid);
  const CostPlanner planner(Planner(Grid(grid), Disc{1}), costs);
  const CostResult result = planner.plan({.start = {4, 1}, .goal = {7, 3}});
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_TRUE(result.way_out);
  EXPECT_EQ(result.path.front(), (Point{4.5, 1.5}));
  EXPECT_NEAR(*path_cost(grid, costs, result.path), result.cost, 1e-12);
  EXPECT_FALSE(result.lower_bound);
  EXPECT_FALSE(result.optimal);
}

// An end where two blocked cells meet is one of the cells on both sides; one on the border of a
// dear cell costs what it does beside it.
TEST(CostPlanner, EndsOnBordersAgainstEndsBeside) {
  constexpr double kBeside = 1e-3;
  std::mt19937 random(47);
  int squeezed = 0;
  for (int i = 0; i < 300; ++i) {
    auto [grid, costs, cell, goal] = random_weights(random, 4, 6);
    if (const Cell left{cell.x - 1, cell.y}, up{cell.x, cell.y - 1};
        i % 2 == 0 && cell.x > 0 && cell.y > 0 && goal != left && goal != up) {
      grid.set_blocked(left);
      grid.set_blocked(up);
    }
    const CostPlanner planner(Planner(Grid(grid)), costs);
    for (const Point at : {Point{1.0 * cell.x, 1.0 * cell.y}, Point{cell.x + 0.3, cell.y + 1.0}}) {
      const CostResult found = planner.plan({.goal = goal, .start_point = at});
      double least = kInfinity, bound = kInfinity, dearest = 0;
      for (const double dx : {-kBeside, kBeside})
        for (const double dy : {-kBeside, kBeside}) {
          const Cell side{static_cast<int>(std::floor(at.x + dx)),
                          static_cast<int>(std::floor(at.y + dy))};
          if (!grid.free(side)) continue;
          const CostResult beside =
              planner.plan({.goal = goal, .start_point = Point{at.x + dx, at.y + dy}});
          dearest = std::max(dearest, 2 * kBeside * costs.weight(side));
          if (beside.path.empty()) continue;
          least = std::min(least, beside.cost);
          bound = std::min(bound, *beside.lower_bound);
        }
      if (!(least < kInfinity)) continue;
      ASSERT_FALSE(found.path.empty()) << i;
      EXPECT_EQ(found.path.front(), at);
      EXPECT_NEAR(*path_cost(grid, costs, found.path), found.cost, 1e-9 * found.cost);
      EXPECT_LE(found.cost, least * 1.003 + dearest) << i;
      EXPECT_LE(*found.lower_bound, least + dearest) << i;
      EXPECT_GE(*found.lower_bound, bound * 0.98 - dearest) << i;
      const bool joined = grid.free({cell.x - 1, cell.y}) || grid.free({cell.x, cell.y - 1});
      squeezed += at.x == cell.x && !joined && grid.free({cell.x - 1, cell.y - 1}) ? 1 : 0;
    }
    const CostResult stays = planner.plan({.start_point = Point{1.0 * cell.x, cell.y + 0.5},
                                           .goal_point = Point{1.0 * cell.x, cell.y + 0.5}});
    EXPECT_EQ(stays.path.size(), 1u);
    EXPECT_TRUE(stays.optimal);
  }
  EXPECT_GT(squeezed, 20);
}

TEST(CostPlanner, VerticesOfStraightPiecesAreLeftOut) {
  const Grid grid(60, 60);
  CostField costs(60, 60);
  std::vector<double> left(3600, 0);
  for (const Cell c : cells_of(grid)) left[c.y * 60 + c.x] = c.x < 30;
  costs.add(left);
  const CostResult result = CostPlanner(Planner(Grid(grid)), costs).plan({{2, 3}, {55, 50}});
  ASSERT_EQ(result.path.size(), 3);  // refracted where the weight changes
  EXPECT_NEAR(result.path[1].x, 30, 1e-9);
  const auto sine = [&](Point a, Point b) {
    return (b.y - a.y) / std::hypot(b.x - a.x, b.y - a.y);
  };
  EXPECT_NEAR(2 * sine(result.path[0], result.path[1]), sine(result.path[1], result.path[2]), 1e-5);
}

TEST(CostPlanner, AColonysPathThroughAPointIsCountedFromTheStart) {
  const Grid grid(40, 30);
  const CostField costs = striped(grid);
  CostOptions options{.params = Params("mmas")};
  options.params.iterations = 3;
  const CostResult result =
      CostPlanner(Planner(Grid(grid)), costs)
          .plan({.start = {2, 3}, .goal = {35, 4}, .via = {{20.5, 25.5}}}, options);
  ASSERT_FALSE(result.path.empty());
  EXPECT_NEAR(result.cost, *path_cost(grid, costs, result.path), 1e-9);
  EXPECT_NEAR(result.curves.best.back(), result.cost, 1e-9);
}

TEST(CostPlanner, ObserversSeeCheaperPathsAndEndTheSearch) {
  const Grid grid(60, 60);
  const CostField costs = striped(grid);
  const CostPlanner planner(Planner(Grid(grid)), costs);
  double last = 1e300;
  int calls = 0;
  const CostResult whole = planner.plan(
      {.start = {2, 3}, .goal = {55, 50}}, {.observer = [&](const GridProgress& progress) {
        EXPECT_LT(progress.best_length, last);
        EXPECT_NEAR(progress.best_length, *path_cost(grid, costs, progress.path()), 1e-9);
        EXPECT_EQ(progress.iteration, calls++);
        last = progress.best_length;
      }});
  EXPECT_GE(calls, 2);
  EXPECT_EQ(whole.cost, last);
  const CostResult again = planner.plan({.start = {2, 3}, .goal = {55, 50}});
  EXPECT_EQ(again.path, whole.path);
  EXPECT_EQ(again.lower_bound, whole.lower_bound);
  const CostResult cut = planner.plan({.start = {2, 3}, .goal = {55, 50}},
                                      {.observer = [](const GridProgress&) { return Go::stop; }});
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_GT(cut.cost, whole.cost);
}

}  // namespace
}  // namespace lasius
