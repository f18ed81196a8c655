// A Navigator over costs: its weights are those of a field made anew, its ways no dearer than the
// cheapest walk, and what it keeps is as good as what a new one finds.
#include <gtest/gtest.h>

#include "core/cost/eight_moves.h"
#include "core/drive/path_walker.h"
#include "lasius/base/error.h"
#include "lasius/cost/planner.h"
#include "lasius/drive/drive.h"
#include "lasius/drive/navigator.h"
#include "lasius/params/params.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/near_clearance.h"
#include "tests/worlds/changing_world.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

constexpr Inflation kInflation{.radius = 4.5, .scaling = 0.7, .weight = 3, .inscribed = 1.2};

CostField draw_costs(Draw& draw, const Grid& map) {
  std::vector<double> weights;
  for (int i = 0; i < map.width() * map.height(); ++i)
    weights.push_back(0.5 + 0.25 * draw.below(8));
  return CostField(map.width(), map.height(), weights);
}

/// The cells' weights, and the navigator's, with another one of a cell.
CostField with_weight(const CostField& given, Cell at, double weight, Navigator& navigator) {
  navigator.set_costs({at.x, at.y, 1, 1}, std::vector<double>{weight});
  std::vector<double> weights(given.weights().begin(), given.weights().end());
  weights[static_cast<std::size_t>(at.y) * given.width() + at.x] = weight;
  return CostField(given.width(), given.height(), weights);
}

/// Edits the map and its costs at random, and the robot goes on.
int compare_with_new_costs(double radius, int worlds) {
  int ways = 0;
  for (int seed = 0; seed < worlds; ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed));
    const int width = 20 + draw.below(50), height = 20 + draw.below(50);
    const Grid map = draw_map(draw, width, height);
    CostField given = draw_costs(draw, map);
    const Cell goal = draw_free(draw, map);
    Navigator navigator(
        map, goal, {.radius = radius, .costs = given, .inflation = kInflation, .doubt_after = 0});
    Cell robot = draw_free(draw, map);
    for (int i = 0; i < 25; ++i) {
      const Way& way = navigator.step(robot);
      CostField costs = given;
      costs.add(navigator.map(), kInflation);
      const cost::Terrain terrain(navigator.passable(), costs);
      const StopCondition never;
      Poller poller(never);
      const auto walk = cost::EightMoves().search(
          terrain, robot, goal, rule_of_walks(navigator.corners()), poller, false);
      if (!way.way_out && navigator.passable().free(robot)) {
        EXPECT_EQ(way.path.empty(), walk.empty()) << seed << ' ' << i << way.error;
      }
      if (!way.path.empty() && !way.way_out) {
        ++ways;
        double least = 0;
        for (std::size_t k = 1; k < walk.size(); ++k)
          least += terrain.move_cost(walk[k - 1], walk[k]);
        EXPECT_EQ(way.walk.front(), robot);
        EXPECT_NEAR(way.walk_cost, least, 1e-9 * least);
        EXPECT_LE(way.cost, least * (1 + 1e-9));
        EXPECT_NEAR(way.length, path_length(way.path), 1e-9);
        const auto cost = path_cost(navigator.passable(), costs, way.path);
        EXPECT_TRUE(cost || navigator.corners() == Corners::allow);
        if (cost) {
          EXPECT_NEAR(way.cost, *cost, 1e-9 * way.cost);
        }
        if (radius == 0) {
          const CostPlanner planner(Planner(Grid(navigator.passable())), costs);
          const auto best = planner.plan({.start = robot, .goal = goal, .target_gap = 0.05});
          EXPECT_GE(way.cost, *best.lower_bound);
        }
        for (std::size_t k = 1; k < way.path.size() && radius > 0; ++k)
          EXPECT_GE(
              oracle::near_clearance(navigator.map(), way.path[k - 1], way.path[k], radius + 1),
              radius - 1e-8);
        robot = way.walk[std::min<std::size_t>(draw.below(3), way.walk.size() - 1)];
      }
      if (draw.one_in(4)) continue;
      navigator.observe(draw_part(draw, map, 5), draw.one_in(2));
      if (draw.one_in(3)) {
        const Cell at{draw.below(map.width()), draw.below(map.height())};
        given = with_weight(given, at, 0.25, navigator);
      }
    }
  }
  return ways;
}

TEST(CostWays, AreTheCheapestWalksPolished) { EXPECT_GT(compare_with_new_costs(0, 25), 200); }
TEST(CostWays, OfADiscKeepItsRadius) {
  int ways = 0;
  for (const double radius : {0.4, 0.8, 1.3, 2.2}) ways += compare_with_new_costs(radius, 15);
  EXPECT_GT(ways, 200);
}

TEST(CostWays, OfADiscPassBetweenCellsThatItsCentreMayNotBeIn) {
  Draw draw(3);
  int passed = 0;
  for (int maps = 0; maps < 600; ++maps) {
    const Grid map = grid_of(16, 16, [&](int, int) { return draw.one_in(40); });
    for (const double radius : {0.8, 1.3, 2.0}) {
      Navigator navigator(map, {0, 0}, {.radius = radius, .costs = CostField(16, 16)});
      const Grid& passable = navigator.passable();
      for (const Cell c : cells_of(Rectangle{0, 0, 15, 15})) {
        const Cell over{c.x + 1, c.y + 1};
        if (passable.blocked(c) || passable.blocked(over) || passable.free({over.x, c.y}) ||
            passable.free({c.x, over.y}))
          continue;
        navigator.set_goal(over);
        const Way& way = navigator.step(c);
        EXPECT_EQ(way.walk, (std::vector<Cell>{c, over}));
        EXPECT_DOUBLE_EQ(way.cost, way.walk_cost);
        EXPECT_NEAR(way.cost, 1.4142135623730951, 1e-12);
        ++passed;
      }
    }
  }
  EXPECT_GT(passed, 20);
}

TEST(CostWays, AreKeptWhereNothingMadeAnotherCheaper) {
  const Grid map(60, 20);
  Navigator navigator(map, {55, 10}, {.inflation = kInflation});
  EXPECT_TRUE(navigator.step({5, 10}).replanned);
  EXPECT_FALSE(navigator.step({5, 10}).replanned);
  EXPECT_FALSE(navigator.step({6, 10}).replanned);
  navigator.observe(std::vector<Cell>{{30, 1}}, true);  // inflated nowhere near the way
  EXPECT_FALSE(navigator.step({7, 10}).replanned);
  navigator.observe(std::vector<Cell>{{30, 10}}, true);
  const Way& round = navigator.step({7, 10});
  EXPECT_TRUE(round.replanned);
  EXPECT_GT(round.cost, 48);
  navigator.observe(std::vector<Cell>{{30, 10}}, false);
  EXPECT_TRUE(navigator.step({7, 10}).replanned);
  EXPECT_DOUBLE_EQ(navigator.step({7, 10}).cost, 48);
}

TEST(CostWays, AStepCanBeStopped) {
  const Grid map = walled(400, 400, {{200, 0, 1, 399}});
  const Cell start{5, 5}, goal{390, 5};
  const NavigatorOptions options{.costs = CostField(400, 400)};
  Navigator whole(map, goal, options);
  const CountingTime counted(1 << 30);
  const Way way = whole.step(start, counted.is_up());
  EXPECT_EQ(way.status, Status::solved);
  ASSERT_GT(counted.polls(), 5);
  for (int polls = 0; polls < counted.polls(); ++polls) {
    Navigator navigator(map, goal, options);
    const CountingTime time(polls);
    const Way& cut = navigator.step(start, time.is_up());
    EXPECT_TRUE(cut.status == Status::limit || cut.path == way.path) << polls;
    EXPECT_EQ(navigator.step(start).path, way.path) << polls;
  }
}

TEST(CostWays, AreRefusedWhatGoesNotTogether) {
  const Grid map(10, 10);
  const auto refused = [&](const NavigatorOptions& options) {
    EXPECT_THROW(Navigator(map, {1, 1}, options), Error);
  };
  refused({.params = Params("as"), .inflation = kInflation});
  refused({.prepare = PrepareOptions{}, .inflation = kInflation});
  refused({.target_gap = 0.01, .inflation = kInflation});
  refused({.costs = CostField(9, 10)});
  refused({.inflation = Inflation{.radius = -1}});
  refused({.inflation = Inflation{.radius = 1, .weight = CostField::kMost}});
  Navigator plain(map, {1, 1}), weighed(map, {1, 1}, {.costs = CostField(10, 10)});
  EXPECT_THROW(plain.set_costs({0, 0, 1, 1}, std::vector<double>{2.0}), Error);
  EXPECT_THROW(weighed.set_costs({9, 0, 2, 1}, std::vector<double>{2.0, 2.0}), Error);
  EXPECT_THROW(weighed.set_costs({0, 0, 1, 1}, std::vector<double>{0.0}), Error);
  EXPECT_DOUBLE_EQ(weighed.step({1, 5}).cost, 4);
}

}  // namespace
}  // namespace lasius
