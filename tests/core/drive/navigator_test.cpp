#include "lasius/drive/navigator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/oracle/disc_paths.h"
#include "tests/worlds/changing_world.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

/// The walk begins at the robot, moves as a king does, cuts no corner, and touches the path.
void expect_walkable(const Navigator& navigator, Cell robot, const Way& way) {
  ASSERT_FALSE(way.walk.empty());
  EXPECT_EQ(way.walk.front(), robot);
  if (robot != navigator.goal()) {
    EXPECT_GT(way.walk.size(), 1u);
  }
  const Grid& grid = navigator.passable();
  const bool squeezes = navigator.corners() == Corners::allow;
  for (std::size_t i = 1; i < way.walk.size(); ++i) {
    const Cell a = way.walk[i - 1], b = way.walk[i];
    EXPECT_LE(std::abs(a.x - b.x), 1);
    EXPECT_LE(std::abs(a.y - b.y), 1);
    EXPECT_NE(a, b);
    EXPECT_TRUE(grid.free(b) && (squeezes || (grid.free({a.x, b.y}) && grid.free({b.x, a.y}))));
  }
}

void observe_some(Draw& draw, const Grid& map, Navigator& navigator) {
  const bool blocked = draw.one_in(2);
  if (draw.one_in(2)) {
    navigator.observe(draw_part(draw, map, 6), blocked);
    return;
  }
  std::vector<Cell> cells;
  for (int n = draw.below(10); n >= 0; --n) {
    cells.push_back({draw.below(map.width()), draw.below(map.height())});
  }
  navigator.observe(cells, blocked);
}

void expect_clear(const Navigator& navigator, double radius, const Way& way) {
  if (radius == 0) {
    EXPECT_EQ(path_fault(navigator.passable(), way.path), std::nullopt);
    return;
  }
  const oracle::DiscPaths judge(navigator.map(), radius, oracle::DiscPaths::Lines::none);
  for (std::size_t p = 1; p < way.path.size(); ++p)
    EXPECT_GE(judge.clearance(way.path[p - 1], way.path[p]), radius - 2e-9);
}

/// The robot goes on some steps along its walk; where it is then.
Cell gone_on(Draw& draw, Navigator& navigator, const Way& way, Cell robot, bool replans) {
  for (std::size_t step = 1; step < way.walk.size(); ++step) {
    robot = way.walk[step];
    EXPECT_TRUE(!navigator.step(robot).replanned || replans);
    if (draw.one_in(8)) break;
  }
  // From here a way is asked for anew, since a kept one is as it was planned.
  navigator.forget();
  return robot;
}

/// Edits at random; after each the way must be as good as a fresh planner's, from where the robot
/// was when it was planned.
int compare_with_fresh_planners(const NavigatorOptions& options, int worlds, int edits) {
  int ways = 0, doors = 0;
  for (int seed = 0; seed < worlds; ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed));
    const int width = 20 + draw.below(60), height = 20 + draw.below(60);
    const Grid map = draw_map(draw, width, height);
    Navigator navigator(map, draw_free(draw, map), options);
    Cell robot = draw_free(draw, map);
    for (int i = 0; i < edits; ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", edit " + std::to_string(i));
      observe_some(draw, map, navigator);
      const Way& way = navigator.step(robot);  // which may take walls that it doubts away
      const Planner planner(navigator.map(), Disc{options.radius});
      EXPECT_EQ(navigator.passable(), planner.passable());
      const Result fresh = planner.plan({robot, navigator.goal()});
      if (navigator.passable().blocked(robot)) {
        // It walks out over centres; a planner leads a disc out straight to a clear point.
        if (!way.way_out) {
          EXPECT_EQ(way.fault, Fault::start_blocked);
          EXPECT_TRUE(way.path.empty());
          continue;
        }
        if (!fresh.path.empty()) {
          EXPECT_TRUE(fresh.way_out);
        }
        ++ways;
        const Cell out{static_cast<int>(way.way_out->x), static_cast<int>(way.way_out->y)};
        EXPECT_TRUE(navigator.passable().free(out));
        if (!navigator.connected(out, navigator.goal())) ++doors;
        continue;
      }
      EXPECT_FALSE(way.way_out);
      EXPECT_EQ(way.status, fresh.status);
      EXPECT_EQ(way.fault, fresh.fault);
      if (fresh.path.empty()) {
        EXPECT_TRUE(way.path.empty());
        EXPECT_TRUE(way.walk.empty());
        continue;
      }
      ++ways;
      expect_clear(navigator, options.radius, way);
      if (navigator.connected(robot, navigator.goal())) expect_walkable(navigator, robot, way);
      if (options.radius > 0 && way.curve.empty() && robot != navigator.goal()) {
        ++doors;  // no walk follows the curve
        EXPECT_GE(way.length, fresh.length);
        continue;
      }
      // A kept way may be another one of the same length.
      EXPECT_NEAR(way.length, fresh.length, 1e-9 * fresh.length);
      // To stand still lets the next way be compared, too; to go on, its walk.
      if (draw.one_in(4)) robot = gone_on(draw, navigator, way, robot, options.radius > 0);
    }
  }
  EXPECT_LE(doors, ways / 20);
  return ways;
}

TEST(Navigator, IsAsGoodAsAFreshPlannerAfterEveryEdit) {
  EXPECT_GT(compare_with_fresh_planners({}, 60, 80), 2000);
}

TEST(Navigator, IsAsGoodAsAFreshPlannerForARobotWithARadius) {
  EXPECT_GT(compare_with_fresh_planners({.radius = 1.2}, 100, 40), 200);
}

TEST(Navigator, IsAsGoodOnAPreparedMap) {
  NavigatorOptions options;
  options.prepare.emplace();
  EXPECT_GT(compare_with_fresh_planners(options, 30, 60), 700);
}

TEST(Navigator, WalksToTheGoalPieceByPiece) {
  const Grid map = blobs(300, 200);
  const Planner planner(map);
  const Request ends = far_apart(planner);
  Navigator navigator(map, ends.goal);
  Cell robot = ends.start;
  double travelled = 0;
  int replans = 0;
  for (int moves = 0; robot != ends.goal && moves < 2000; ++moves) {
    const Way& way = navigator.step(robot);
    replans += way.replanned ? 1 : 0;
    ASSERT_GT(way.walk.size(), 1u);
    travelled += std::hypot(way.walk[1].x - robot.x, way.walk[1].y - robot.y);
    robot = way.walk[1];
  }
  EXPECT_EQ(robot, ends.goal);
  EXPECT_EQ(replans, 1);
  // Walks of eight neighbours are at most 8.3% longer than what they follow.
  EXPECT_LT(travelled, 1.12 * planner.plan(ends).length);
}

TEST(Navigator, KeepsAWayThatAnEditDoesNotConcern) {
  Navigator navigator(Grid(100, 100), {90, 10});
  EXPECT_TRUE(navigator.step({10, 10}).replanned);
  EXPECT_FALSE(navigator.step({10, 10}).replanned);
  navigator.observe(Rectangle{30, 60, 5, 5}, true);
  EXPECT_FALSE(navigator.step({10, 10}).replanned);
  navigator.observe(Rectangle{30, 60, 5, 5}, false);
  EXPECT_FALSE(navigator.step({10, 10}).replanned);
  navigator.observe(Rectangle{50, 8, 1, 5}, true);
  EXPECT_TRUE(navigator.step({10, 10}).replanned);
  EXPECT_GT(navigator.step({10, 10}).length, 80);
  navigator.observe(Rectangle{50, 8, 1, 5}, false);
  EXPECT_TRUE(navigator.step({10, 10}).replanned);
  EXPECT_EQ(navigator.step({10, 10}).length, 80);
}

TEST(Navigator, AHostileWorldIsAnAnswer) {
  Navigator navigator(Grid(9, 9), {8, 8});
  navigator.observe(Rectangle{4, 0, 1, 9}, true);
  EXPECT_EQ(navigator.step({0, 0}).status, Status::unreachable);
  EXPECT_FALSE(navigator.connected({0, 0}, {8, 8}));
  navigator.observe(std::vector<Cell>{{0, 0}}, true);
  EXPECT_EQ(navigator.step({0, 0}).fault, Fault::start_blocked);
  navigator.observe(std::vector<Cell>{{8, 8}, {-1, 3}, {9, 9}}, true);
  EXPECT_EQ(navigator.step({1, 1}).fault, Fault::goal_blocked);
  EXPECT_EQ(navigator.step({-5, 1}).fault, Fault::start_outside);
  navigator.set_goal({20, 20});
  EXPECT_EQ(navigator.step({1, 1}).fault, Fault::goal_outside);
  navigator.observe(Rectangle{-10, -10, 100, 100}, false);
  navigator.set_goal({8, 8});
  EXPECT_EQ(navigator.step({0, 0}).status, Status::solved);
}

TEST(Navigator, EveryColonyDrives) {
  int driven = 0;
  for (const char* name : colonies()) {
    Navigator navigator(blobs(60, 40), Cell{55, 35}, {.params = quick(name)});
    if (navigator.map().blocked({55, 35})) navigator.observe(Rectangle{54, 34, 3, 3}, false);
    navigator.observe(Rectangle{2, 2, 3, 3}, false);
    const Way& way = navigator.step({3, 3});
    if (way.path.empty()) continue;  // mortal ants
    expect_walkable(navigator, {3, 3}, way);
    const Cell middle = way.walk[way.walk.size() / 2];
    navigator.observe(std::vector<Cell>{middle}, true);
    const Way& next = navigator.step({3, 3});
    EXPECT_TRUE(next.replanned) << name;
    if (next.path.empty()) continue;
    const Corners rule = quick(name).corners;
    EXPECT_EQ(path_fault(navigator.map(), next.path, rule), std::nullopt) << name;
    ++driven;
  }
  EXPECT_GE(driven, 6);
}

TEST(Navigator, RefusesBadOptions) {
  EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, {.radius = -1}), Error);
  EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, {.target_gap = -1}), Error);
  EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, {.params = Params("acs"), .target_gap = 0.1}), Error);
  // Options that the algorithm ignores.
  NavigatorOptions prepared{.params = Params("acs")};
  prepared.prepare.emplace();
  EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, prepared), Error);
  for (const char* name : {"exact", "grid-ga"})
    EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, {.params = Params(name), .search_on = true}), Error);
  EXPECT_NO_THROW(Navigator(Grid(3, 3), {0, 0}, {.params = Params("acs"), .search_on = true}));
  Params bad("acs");
  bad.ants = 0;
  EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, {.params = bad}), Error);
}

TEST(Navigator, APreparedMapHoldsNoMoreMemoryAfterManyEdits) {
  const Grid map = blobs(64, 64);
  NavigatorOptions options;
  options.prepare.emplace();
  Navigator navigator(map, {60, 60}, options);
  Draw draw(6);
  std::int64_t early = 0;
  const auto edits = static_cast<int>(worlds(4000));
  for (int i = 0; i < edits; ++i) {
    const std::vector<Cell> cell{{draw.below(64), draw.below(64)}};
    navigator.observe(cell, map.free(cell[0]));
    navigator.observe(cell, map.blocked(cell[0]));
    if (i == edits / 2) early = navigator.preparation().bytes;
  }
  EXPECT_EQ(navigator.preparation().state, Preparation::State::ready);
  EXPECT_LE(navigator.preparation().bytes, early + early / 10);
}

TEST(Navigator, HoldsNoMoreMemoryAfterManyEdits) {
  const Grid map = blobs(200, 200);
  const Request ends = far_apart(Planner(map));
  Navigator navigator(map, ends.goal);
  Draw draw(5);
  std::int64_t early = 0;
  const auto edits = static_cast<int>(worlds(20'000));
  for (int i = 0; i < edits; ++i) {
    const Rectangle part = draw_part(draw, map, 4);
    navigator.observe(part, true);
    navigator.observe(part, false);
    for (const Cell c : cells_of(part)) navigator.observe(std::vector<Cell>{c}, map.blocked(c));
    if (i % 10 == 0) (void)navigator.step(ends.start);
    if (i == edits / 2) early = navigator.bytes();
  }
  EXPECT_EQ(navigator.map(), map);
  EXPECT_LE(navigator.bytes(), early + early / 10);
}

}  // namespace
}  // namespace lasius
