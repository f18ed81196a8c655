
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/genetic/grid_ga_route.h"
#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/loop/same_result.h"
#include "tests/oracle/visibility_graph.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using Cells = std::vector<Cell>;

// A pocket that opens towards the start: the greedy walk enters it.
Grid pocket() {
  return drawn({"...............",  //
                "...............",  //
                "......######...",  //
                "...........#...",  //
                "...........#...",  //
                "...........#...",  //
                "...........#...",  //
                "...........#...",  //
                "......######...",  //
                "...............",  //
                "..............."});
}
constexpr Cell kStart{1, 5}, kGoal{13, 5};

Params genetic(Polish polish) {
  Params p("grid-ga");
  p.polish = polish;
  p.threads = 1;
  return p;
}

TEST(RouteMaker, StepsBackOutOfADeadEnd) {
  const Grid grid = drawn({"....",  //
                           ".##.",  //
                           "..#.",  //
                           "...."});
  RouteMaker maker;
  maker.reset(grid, Neighbours::four, Corners::forbid, {});
  Poller poller(kNeverStops, 1000);
  Cells route{{0, 2}};
  // Nearest to (3, 2) is (1, 2), whose ways on are (1, 3) only.
  ASSERT_TRUE(maker.extend(route, {3, 2}, poller));
  EXPECT_EQ(route, (Cells{{0, 2}, {1, 2}, {1, 3}, {2, 3}, {3, 3}, {3, 2}}));
  // With row 3 closed, (1, 2) is a dead end, and the walk goes round the top.
  Grid closed = grid;
  for (int x = 1; x < 4; ++x) closed.set_blocked({x, 3});
  maker.reset(closed, Neighbours::four, Corners::forbid, {});
  route = {{0, 2}};
  ASSERT_TRUE(maker.extend(route, {3, 2}, poller));
  EXPECT_EQ(route, (Cells{{0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}}));
}

TEST(RouteMaker, LeavesTheRouteWhereThereIsNoWay) {
  const Grid grid = drawn({"..#.",  //
                           "..#."});
  RouteMaker maker;
  maker.reset(grid, Neighbours::eight, Corners::forbid, {});
  Poller poller(kNeverStops, 1000);
  Cells route{{0, 0}, {1, 0}};
  EXPECT_FALSE(maker.extend(route, {3, 0}, poller));
  EXPECT_EQ(route, (Cells{{0, 0}, {1, 0}}));
  // What a failed walk entered is open to the next one.
  EXPECT_TRUE(maker.extend(route, {0, 1}, poller));
  EXPECT_EQ(route, (Cells{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(RouteMaker, WalksAsBeforeOnceItWasCutShortAndReset) {
  for (const int side : {300, 3000}) {
    const Grid grid(side, side);
    Poller poller(kNeverStops);
    Cells expected{{0, 0}};
    RouteMaker fresh, kept;
    fresh.reset(grid, Neighbours::eight, Corners::forbid, kNeverStops);
    ASSERT_TRUE(fresh.extend(expected, {side - 1, side - 1}, poller));
    for (const int cells : {1, 100, 299}) {
      const CountingTime time(0);
      const StopCondition up = time.is_up();
      Poller until(up, 4 * cells);
      Cells route{{0, 0}};
      kept.reset(grid, Neighbours::eight, Corners::forbid, kNeverStops);
      EXPECT_FALSE(kept.extend(route, {side - 1, side - 1}, until));
      EXPECT_EQ(route, (Cells{{0, 0}}));
      kept.reset(grid, Neighbours::eight, Corners::forbid, kNeverStops);
      ASSERT_TRUE(kept.extend(route, {side - 1, side - 1}, poller));
      EXPECT_EQ(route, expected);
    }
    EXPECT_LE(kept.bytes(), fresh.bytes());
  }
}

TEST(RouteMaker, ObeysTheRuleOfCorners) {
  const Grid grid = drawn({".#",  //
                           ".."});
  Poller poller(kNeverStops, 1000);
  const auto walk = [&](Corners corners) {
    Cells route{{0, 0}};
    RouteMaker maker;
    maker.reset(grid, Neighbours::eight, corners, {});
    EXPECT_TRUE(maker.extend(route, {1, 1}, poller));
    return route.size();
  };
  EXPECT_EQ(walk(Corners::forbid), 3u);
  EXPECT_EQ(walk(Corners::one_side), 2u);
  EXPECT_EQ(walk(Corners::allow), 2u);
}

TEST(GridGa, FirstIndividualOfAnEmptyMapIsOptimal) {
  const Planner planner(Grid(40, 30));
  Params p = genetic(Polish::none);
  p.iterations = 1;
  p.population = 2;
  const Result result = planner.plan({{2, 3}, {35, 20}}, p);
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_NEAR(result.length, 17 * std::sqrt(2.0) + 16, 1e-12);
}

// Scattered obstacles, and two cells far apart.
struct World {
  Grid grid = generate(MapKind::random, {.width = 120, .height = 90, .density = 0.3, .seed = 5});
  Planner planner{grid};
  Cell start = planner.nearest_free({3, 3}).value();
  Cell goal = planner.nearest_free({115, 85}).value();
};

TEST(GridGa, ImprovesTowardsTheOptimumAndNeverBelow) {
  const World world;
  const double optimum = oracle::VisibilityGraph(world.grid).octile(world.start, world.goal);
  ASSERT_TRUE(std::isfinite(optimum));
  int improved = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    Params p = genetic(Polish::none);
    p.population = 20;
    p.seed = seed;
    const Result result = world.planner.plan({world.start, world.goal}, p);
    ASSERT_EQ(result.status, Status::solved);
    ASSERT_EQ(result.curves.best.size(), 100u);
    EXPECT_GE(result.length, optimum - 1e-9);
    EXPECT_LE(result.length, 1.25 * optimum);
    EXPECT_TRUE(std::is_sorted(result.curves.best.rbegin(), result.curves.best.rend()));
    EXPECT_EQ(path_fault(world.grid, result.path), std::nullopt);
    for (std::size_t i = 0; i < result.curves.best.size(); ++i)
      EXPECT_GE(result.curves.mean[i], result.curves.best[i] - 1e-9);
    improved += result.curves.best.back() < result.curves.best.front();
  }
  EXPECT_GE(improved, 8);
}

/// True when the cells are the first part of one path and then the last part of another, joined at
/// a cell of both; fewer where loops were cut.
bool crossed(const Cells& child, const Cells& one, const Cells& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto joint = std::find(other.begin(), other.end(), one[i]);
    if (joint == other.end()) continue;
    const auto is_in = [](auto first, auto last) {
      return [=](Cell c) { return std::find(first, last, c) != last; };
    };
    const auto before = is_in(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(i));
    const auto behind = is_in(joint, other.end());
    if (std::ranges::all_of(child, [&](Cell c) { return before(c) || behind(c); })) return true;
  }
  return false;
}

// Without mutation, a child is made of its parents, but no union of them: it may be worse. Its
// sibling has the other parts.
TEST(GridGa, AChildIsTheFirstPartOfOneParentAndTheLastOfTheOther) {
  Grid rooms(41, 31);  // two, with a door: where ways part before it, others part behind it
  for (int y = 0; y < 31; ++y) rooms.set_blocked({20, y}, y != 15);
  const Planner planner(rooms);
  const Request request{.start = {3, 15}, .goal = {37, 15}};
  int longer = 0;
  for (int seed = 1; seed <= 30; ++seed) {
    Params p = genetic(Polish::none);
    p.neighbours = Neighbours::four;
    p.mutation = 0;
    p.population = 10;
    p.iterations = 6;
    p.seed = static_cast<std::uint64_t>(seed);
    std::vector<Cells> parents, children;
    const auto look = [&](const GridProgress& seen) {
      parents = std::exchange(children, {});
      std::size_t longest = 0, before = 0;
      for (const Cells& path : parents) before = std::max(before, path.size());
      for (int a = 0; a < seen.ants(); ++a) {
        children.push_back(seen.tour(a));
        longest = std::max(longest, children.back().size());
        if (a % 2 == 0 || parents.empty()) continue;
        const Cells &child = children[children.size() - 2], &sibling = children.back();
        EXPECT_TRUE(std::ranges::any_of(
            parents,
            [&](const Cells& one) {
              return std::ranges::any_of(parents, [&](const Cells& other) {
                return crossed(child, one, other) && crossed(sibling, other, one);
              });
            }))
            << seen.iteration << ", " << a;
      }
      longer += seen.iteration > 0 && longest > before ? 1 : 0;
    };
    (void)planner.plan(request, p, {.observer = look});
  }
  EXPECT_GT(longer, 0);
}

TEST(GridGa, KeepsItsPathsWithoutCrossoverAndMutation) {
  const Planner planner(pocket());
  Params p = genetic(Polish::none);
  p.crossover = p.mutation = 0;
  const Result result = planner.plan({kStart, kGoal}, p);
  EXPECT_EQ(result.curves.best.front(), result.curves.best.back());
  // Tournaments alone: in the end all are the best one.
  EXPECT_NEAR(result.curves.mean.back(), result.curves.best.back(), 1e-9);
  EXPECT_GT(result.curves.mean.front(), result.curves.best.front());
}

TEST(GridGa, EqualForAnyNumberOfThreads) {
  const World world;
  for (const Polish polish : {Polish::none, Polish::straight, Polish::taut}) {
    Params p = genetic(polish);
    p.iterations = 10;
    p.population = 7;
    const Result one = world.planner.plan({world.start, world.goal}, p);
    ASSERT_EQ(one.status, Status::solved);
    EXPECT_EQ(path_fault(world.grid, one.path), std::nullopt);
    for (const int threads : {2, 5}) {
      p.threads = threads;
      expect_same(world.planner.plan({world.start, world.goal}, p), one);
    }
  }
}

TEST(GridGa, FourNeighboursMoveByFour) {
  const Planner planner(pocket());
  Params p = genetic(Polish::none);
  p.neighbours = Neighbours::four;
  const Result result = planner.plan({kStart, kGoal}, p);
  ASSERT_FALSE(result.path.empty());
  for (std::size_t i = 1; i < result.path.size(); ++i)
    EXPECT_EQ(std::abs(result.path[i].x - result.path[i - 1].x) +
                  std::abs(result.path[i].y - result.path[i - 1].y),
              1);
  EXPECT_EQ(result.length, std::round(result.length));
}

TEST(GridGa, StopsByTokenAndDeadline) {
  const Planner planner(pocket());
  const Result token = planner.plan({kStart, kGoal, fired()}, genetic(Polish::straight));
  EXPECT_EQ(token.status, Status::interrupted);
  EXPECT_TRUE(token.curves.best.empty());
  const Result late =
      planner.plan({kStart, kGoal, {.deadline = Clock::now()}}, genetic(Polish::straight));
  EXPECT_EQ(late.status, Status::limit);
}

TEST(GridGa, AnInterruptedRunKeepsItsBestPath) {
  const Planner planner(pocket());
  std::stop_source source;
  int seen = 0;
  const Result result =
      planner.plan({kStart, kGoal, {.token = source.get_token()}}, genetic(Polish::straight),
                   {.observer = [&](const GridProgress& p) {
                     EXPECT_EQ(p.iteration, seen);
                     EXPECT_EQ(p.ants(), 50);
                     EXPECT_EQ(p.tour(0).front(), kStart);
                     EXPECT_EQ(p.tour(49).back(), kGoal);
                     if (++seen == 5) source.request_stop();
                   }});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.curves.iterations, 5);
  EXPECT_EQ(result.length, result.curves.best.back());
}

}  // namespace
}  // namespace lasius
