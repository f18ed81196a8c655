// Obstacles of no width: paths touch them and do not cross them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/polygon/world/rings.h"
#include "lasius/plan/planner.h"
#include "lasius/polygon/plan.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/random_world.h"

namespace lasius::polygon {
namespace {

World room(std::vector<Ring> walls) {
  World world = empty_world(20, 10, Point{1, 1}, Point{19, 1});
  world.walls = std::move(walls);
  return world;
}

TEST(Walls, APathGoesRoundTheirEnds) {
  const Planner planner(room({{{10, 0}, {10, 6}}}));
  EXPECT_EQ(planner.components(), 1);
  const Result exact = planner.plan();
  EXPECT_EQ(exact.path, (std::vector<Point>{{1, 1}, {10, 6}, {19, 1}}));
  EXPECT_NEAR(exact.length, 2 * std::hypot(9, 5), 1e-12);
  for (const char* colony : {"maklink-acs", "real-ga"}) {
    const Result result = planner.plan({}, Params(colony));
    EXPECT_NEAR(result.sequence_optimum->length, exact.length, 1e-12) << colony;
    EXPECT_GE(result.length, exact.length) << colony;
  }
  // One in the middle of the room, bent, and one that stands beside the way.
  const Result bent = Planner(room({{{10, 0.5}, {10, 5}, {12, 3}}, {{3, 8}, {6, 8}}})).plan();
  EXPECT_EQ(bent.path, (std::vector<Point>{{1, 1}, {10, 0.5}, {19, 1}}));
  // On a wall: a path leaves it on either side, slides along it and goes round it.
  const Planner on(room({{{10, 2}, {10, 6}}}));
  for (const Point goal : {Point{9, 4}, Point{11, 4}})
    EXPECT_NEAR(on.plan({.start = Point{10, 4}, .goal = goal}).length, 1, 1e-12);
  EXPECT_NEAR(on.plan({.start = Point{10, 2}, .goal = Point{10, 6}}).length, 4, 1e-12);
  EXPECT_NEAR(on.plan({.start = Point{9.5, 4}, .goal = Point{10.5, 4}}).length,
              2 * std::hypot(0.5, 2), 1e-12);
}

TEST(Walls, ARepairMakesThemOfWhatHasNoWidth) {
  const World world = parse_wkt(
      "POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0)) POLYGON ((10 0, 10 6, 10 0)) POINT (1 1) POINT (19 "
      "1)",
      "w", {.repair = true});
  EXPECT_EQ(world.walls.size(), 1u);
  EXPECT_NEAR(Planner(world).plan().length, 2 * std::hypot(9, 5), 1e-12);
}

TEST(Walls, NothingSlipsBetweenTheirTouchingEnds) {
  const double third = 10.0 / 3;
  World block = room({{{10, 0}, {10, 4}}, {{11, 6}, {11, 10}}});
  block.obstacles = {{{{9, 4}, {12, 4}, {12, 6}, {9, 6}}, {}}};
  World slanted = room({{{9.1, 0.3 * third}, {12, 9}}});
  // Both ends on slanted edges, computed.
  slanted.boundary.outer = {{0, 0}, {20, 2.2}, {20, 10}, {0, 8}};
  slanted.walls = {{{third, third * 0.11}, {third, 8 + third * 0.1}}};
  slanted.start = Point{1, 1}, slanted.goal = Point{19, 4};
  for (const World& world :
       {room({{{10, 0}, {10, 10}}}), room({{{10, -3}, {10, 13}}}),
        room({{{10, 0}, {7, 5}, {10, 10}}}),
        room({{{10, 0}, {10, third}}, {{10, third}, {12, 10}}}),
        room({{{10, 0}, {12, 5}}, {{12, 5}, {5, 5}}, {{5, 5}, {8, 10}}}),
        room({{{4, 0}, {16, 8}}, {{4, 10}, {16, 2}}}),                 // a cross
        room({{{0, third}, {7, third}}, {{7.0 / 3, third}, {2, 0}}}),  // a T
        room({{{0.5, 0.5}, {2, 0.5}, {2, 2}, {0.5, 2}, {0.5, 0.5}}}),  // a closed line
        room({{{10, 0}, {10, 7}}, {{10, 3}, {10, 10}}}),               // along each other
        block, slanted}) {
    const Planner planner(world);
    EXPECT_EQ(planner.components(), 2);
    EXPECT_EQ(planner.plan().status, Status::unreachable);
    for (const double margin : {1e-13, 1e-9, 0.1}) {  // however little they grow by
      for (const Join join : {Join::round, Join::mitre, Join::bevel, Join::chords})
        EXPECT_EQ(Planner(world, {.margin = margin, .join = join}).plan().status,
                  Status::unreachable)
            << margin << to_string(join);
    }
  }
  EXPECT_EQ(Planner(room({{{10, 0}, {10, 4}}, {{10, 4.001}, {10, 10}}})).plan().status,
            Status::solved);
  EXPECT_EQ(Planner(room({{{30, -1e9}, {30, 1e12}}})).plan().length, 18) << "outside";
}

TEST(Walls, TouchFarFromTheOriginWhereComputedPointsDo) {
  for (int i = 0; i < 80; ++i) {
    Dice dice(i);
    const double turn = dice.real(0, 2 * std::numbers::pi);
    const Point far{i % 2 == 0 ? 4.5e5 : -31, i % 2 == 0 ? 5.4e6 : 7};
    const auto at = [&](double x, double y) {
      return Point{far.x + x * std::cos(turn) - y * std::sin(turn),
                   far.y + x * std::sin(turn) + y * std::cos(turn)};
    };
    const auto between = [&](Point a, Point b) {
      const double share = dice.real(0.2, 0.8);
      return Point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    };
    World world;
    world.boundary.outer = {at(0, 0), at(40, 0), at(40, 30), at(0, 30)};
    const Point low = between(at(10, 0), at(30, 0)), high = between(at(10, 30), at(30, 30));
    const Point tip = at(dice.real(12, 28), dice.real(12, 18));
    world.walls = {{low, tip}, {high, between(low, tip)}};
    if (i % 3 == 0) {  // an obstacle in place of the tip
      world.obstacles = {{{tip, at(20, 22), at(12, 12)}, {}}};
      if (i % 2 == 0) std::ranges::reverse(world.obstacles[0].outer);
      world.walls[1][1] = between(world.obstacles[0].outer[0], world.obstacles[0].outer[1]);
    }
    world.start = at(1, 15), world.goal = at(39, 15);
    EXPECT_EQ(Planner(world).plan().status, Status::unreachable) << i;
    world.walls.pop_back();
    EXPECT_EQ(Planner(world).plan().status, Status::solved) << i;
  }
}

TEST(Walls, KeepTheMargin) {
  World world = room({{{10, 0}, {10, 6}}});
  const Result result = Planner(world, {.margin = 1, .boundary = Boundary::keep}).plan();
  // From the circle around the end, touched twice, a quarter of it at most between.
  const double tangent = std::sqrt(9 * 9 + 5 * 5 - 1);
  EXPECT_GE(result.length, 2 * tangent);
  EXPECT_LE(result.length, 2 * tangent + 2);
  for (std::size_t i = 0; i + 1 < result.path.size(); ++i)
    EXPECT_GE(distance_to(result.path[i], result.path[i + 1], {10, 6}), 1 - 1e-9);
  world.goal = Point{10.5, 3};
  EXPECT_EQ(Planner(world, {.margin = 1}).plan().status, Status::invalid);
}

TEST(Walls, BlockTheCellsThatTheyPass) {
  const World world = room({{{4, 0}, {16.2, 9.7}}, {{16.2, 9.7}, {20, 9.7}}, {{-5, 8}, {-5, 90}}});
  const Map map = to_grid(world, 0.5);
  const lasius::Planner planner(map.grid);
  EXPECT_EQ(planner.plan({.start = {0, 10}, .goal = {39, 10}}).status, Status::unreachable);
  EXPECT_LT(map.grid.width() + map.grid.height(), 61);
  EXPECT_TRUE(map.grid.free({0, 0}));
  World small = empty_world(6, 4, Point{1, 1}, Point{5, 1});
  small.walls = {{{1.5, 1.2}, {4.5, 2.2}}};
  EXPECT_EQ(to_grid(small, 1).grid, drawn({"......",  //
                                           "...##.",  //
                                           ".###..",  //
                                           "......"}));
}

/// Walls made into thin areas, which reach a hair beyond their ends.
World thickened(World world, double hair) {
  for (const Ring& wall : world.walls) {
    for (std::size_t i = 0; i + 1 < wall.size(); ++i) {
      const Point a = wall[i], b = wall[i + 1];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const double x = hair * (b.x - a.x) / length, y = hair * (b.y - a.y) / length;
      world.obstacles.push_back({{{a.x - x - y, a.y - y + x},
                                  {a.x - x + y, a.y - y - x},
                                  {b.x + x + y, b.y + y - x},
                                  {b.x + x - y, b.y + y + x}},
                                 {}});
    }
  }
  world.walls.clear();
  return world;
}

TEST(Walls, AreAsThinAreasAmongRandomObstacles) {
  int solved = 0, closed = 0;
  for (int i = 0; i < 40; ++i) {
    const std::string which = "world " + std::to_string(i);
    const double step = i % 2 == 0 ? 0 : 10;  // on a coarse grid they touch, cross and overlap
    World world = random_world(700 + i, i % 12, step);
    world.margin = i % 5 == 0 ? 0.4 : 0;
    Dice dice(900 + i);
    const auto at = [&] {
      const double v = dice.real(-10, 210);
      return step > 0 ? std::round(v / step) * step : v;
    };
    for (int w = 0; w < 3 + i % 14; ++w) {
      Ring wall{{at(), at()}};
      for (int more = dice.whole(1, 3); more > 0; --more) {
        const Point p{at(), at()};
        if (p != wall.back()) wall.push_back(p);
      }
      if (wall.size() > 1) world.walls.push_back(wall);
    }
    const Planner planner(world), thin(thickened(world, 1e-6));
    double whole = 0, cut = 0;
    for (const Polygon& piece : planner.maklink().free_space) {
      whole += std::abs(doubled_area(piece.outer));
      for (const Ring& hole : piece.holes) whole -= std::abs(doubled_area(hole));
    }
    for (const auto& region : planner.maklink().regions) {
      cut += doubled_area(region);
      for (std::size_t c = 0; c < region.size(); ++c) {
        const Point p = region[c], q = region[(c + 1) % region.size()],
                    r = region[(c + 2) % region.size()];
        EXPECT_GE((q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x), -1e-6) << which;
      }
    }
    EXPECT_NEAR(cut, whole, 1e-6 * 40'000) << which;
    for (int q = 0; q < 3; ++q) {
      const Request request = random_request(thin, 40 * i + q);
      const Result result = planner.plan(request), expected = thin.plan(request);
      EXPECT_EQ(result.status, expected.status) << which << ", " << q;
      if (!result.optimal || !expected.optimal) {
        closed += expected.status == Status::unreachable;
        continue;
      }
      EXPECT_NEAR(result.length, expected.length, 1e-3 + 0.05 * world.margin) << which << ", " << q;
      ++solved;
      if (q > 0) continue;
      Params colony("maklink-acs");
      colony.iterations = 20;
      const Result walked = planner.plan(request, colony);
      EXPECT_GE(walked.length, result.length - 1e-9) << which;
    }
  }
  EXPECT_GT(solved, 25);
  EXPECT_GT(closed, 10);
}

}  // namespace
}  // namespace lasius::polygon
