// The robot's margin: how much of it paths keep, at obstacles and at the boundary.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/worlds/disc_bitmap.h"
#include "tests/worlds/random_world.h"

namespace lasius::polygon {
namespace {

TEST(Margin, GrowsClipsAndMerges) {
  World world;
  world.boundary.outer = {{-5, 0}, {20, 0}, {20, 10}, {-5, 10}};
  world.obstacles = {{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}},
                     {{{8, 4}, {10, 4}, {10, 6}, {8, 6}}, {}},
                     {{{18, 8}, {25, 8}, {25, 15}, {18, 15}}, {}}};
  const auto at = [&](double margin, Join join = Join::mitre) {
    return Planner(world, {.margin = margin, .join = join, .boundary = Boundary::keep});
  };
  EXPECT_EQ(at(0.5).grown_obstacles().size(), 3u);
  EXPECT_EQ(at(1.5).grown_obstacles().size(), 2u);  // the two squares merge
  EXPECT_TRUE(at(0.5).free({3.4, 3.4}));
  EXPECT_FALSE(at(0.5).free({3.6, 3.6}));              // a mitre keeps the corner
  EXPECT_TRUE(at(0.5, Join::round).free({3.6, 3.6}));  // 0.566 from the corner
  EXPECT_TRUE(at(0.5, Join::bevel).free({3.7, 3.7}));  // 0.424 from it, behind the bevel
  const Planner half = at(0.5);
  for (const Polygon& p : half.grown_obstacles()) {
    for (const Point q : p.outer) EXPECT_TRUE(q.x <= 20 && q.y <= 10);
  }
  EXPECT_EQ(at(4.5).components(), 2);  // nothing above or below the merged squares
  EXPECT_EQ(at(50).components(), 0);   // no free space
  EXPECT_THROW(at(-1), Error);
  EXPECT_THROW(at(1e308), Error);
}

/// Points along a closed ring, or an open path.
template <class Visit>
void along(const Ring& ring, const Visit& visit, bool closed = true) {
  for (std::size_t i = 0; i + (closed ? 0 : 1) < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    for (int k = 0; k < 16; ++k) visit({a.x + (b.x - a.x) * k / 16, a.y + (b.y - a.y) * k / 16});
  }
}

TEST(Margin, RoundKeepsAllOfItAndHalfAPercentMoreAtMost) {
  for (int i = 0; i < 8; ++i) {
    const World world = random_world(static_cast<std::uint64_t>(500 + i), 8 + 12 * i);
    const double margin = 0.3 + 0.4 * i;
    const Planner planner(world, {.margin = margin});
    double least = 1e9, most = 0;
    const auto share = [&](Point p) { return distance_to_edges(world, p, true) / margin; };
    for (const Polygon& p : planner.grown_obstacles()) {
      for (const Point corner : p.outer) most = std::max(most, share(corner));
      along(p.outer, [&](Point q) {
        const double wall = std::min({q.x, q.y, 200 - q.x, 200 - q.y});
        if (wall > margin * (1 + 1e-9)) least = std::min(least, share(q));  // else cut off there
      });
    }
    EXPECT_GE(least, 1 - 1e-9) << i;
    EXPECT_LE(most, 1.005) << i;
  }
}

TEST(Margin, HoldsAtTheBoundaryUnlessThatIsKept) {
  World world;  // an L: the boundary has a corner that paths bend around
  world.boundary.outer = {{0, 0}, {20, 0}, {20, 20}, {12, 20}, {12, 8}, {0, 8}};
  world.start = Point{1, 7};
  world.goal = Point{13, 19};
  for (const Join join : {Join::round, Join::mitre}) {
    const Planner planner(world, {.margin = 1, .join = join});
    EXPECT_EQ(planner.boundary(), Boundary::shrink);
    EXPECT_FALSE(planner.free({0.9, 4}));
    EXPECT_TRUE(planner.free({1, 4}));
    for (const Algorithm& algorithm : algorithms()) {
      const Result result = planner.plan({}, Params(algorithm.name));
      ASSERT_EQ(result.status, Status::solved);
      along(
          result.path,
          [&](Point p) {
            EXPECT_GE(distance_to_edges(world, p, true), 1 - 1e-9) << algorithm.name;
          },
          false);
    }
  }
  const Planner kept(world, {.margin = 1, .boundary = Boundary::keep});
  EXPECT_TRUE(kept.free({0, 4}));
  EXPECT_NEAR(kept.plan().length, 2 * std::hypot(11, 1), 1e-9);
  const Result none = Planner(world, {.margin = 6}).plan();
  EXPECT_EQ(none.fault, Fault::start_blocked) << "nothing is left";
  expect_says(none.error,
              "start (1, 7) is nearer to what is blocked than the margin of 6; no space is free");
  World block = world;
  block.obstacles = {{{{3, 3}, {5, 3}, {5, 5}, {3, 5}}, {}}};
  const auto refusal = [&](Point start) {
    return Planner(block, {.margin = 0.5}).plan({.start = start, .goal = {}}).error;
  };
  expect_says(refusal({4, 4}), "start (4, 4) is blocked; the nearest");
  expect_says(refusal({2.75, 4}),
              "start (2.75, 4) is nearer to what is blocked than the margin of 0.5; the nearest");
}

TEST(Margin, AMitreThatClosesAPassageSaysSo) {
  // Two thin spikes, tip to tip, 8 apart: room for a margin of 2.
  World world = empty_world(60, 40, Point{5, 20}, Point{55, 20});
  world.obstacles = {{{{28, 0}, {32, 0}, {30, 16}}, {}}, {{{28, 40}, {30, 24}, {32, 40}}, {}}};
  world.margin = 2;
  const Planner round(world);
  EXPECT_EQ(round.join(), Join::round);
  Result result = round.plan();
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.note, "");
  const Planner mitre(world, {.margin = {}, .join = Join::mitre});
  result = mitre.plan();
  EXPECT_EQ(result.status, Status::unreachable);
  expect_says(result.note, "round joins start and goal are joined");
  result = mitre.plan({.start = Point{30, 20}});
  EXPECT_EQ(result.status, Status::invalid);
  expect_says(result.note, "round joins the start is free");
  EXPECT_EQ(mitre.plan({.start = Point{-3, 5}}).note, "");  // outside, whatever the joins
  result = mitre.plan({.goal = Point{6, 6}});
  EXPECT_EQ(result.status, Status::solved);
  expect_says(result.note, "mitre joins close passages");
  world.obstacles.pop_back();
  EXPECT_EQ(Planner(world, {.margin = {}, .join = Join::mitre}).plan().note, "");
}

// Lines are drawn among corners that reach beyond the margin: beside one paths go straight to them.
TEST(Margin, StartsAndGoalsBesideAnArcAreFree) {
  World world = empty_world(40, 40);
  world.obstacles = {{{{10, 10}, {30, 10}, {30, 30}, {10, 30}}, {}}};
  world.margin = 4;
  const Point start{10 - 2.9, 10 - 2.9}, goal{30 + 2.9, 30 + 2.9};  // 4.1 from the corners
  const Planner planner(world);
  EXPECT_TRUE(planner.free(start));
  const double optimum = planner.plan({.start = start, .goal = goal}).length;
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    const Result result = planner.plan({.start = start, .goal = goal}, Params(algorithm));
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_EQ(result.path.front(), start);
    EXPECT_EQ(result.path.back(), goal);
    EXPECT_EQ(result.optimum, optimum);
    EXPECT_LE(result.length, 1.1 * optimum);
    EXPECT_NEAR(result.curves.best.back(), result.length, 1e-9);
    const auto keeps = [&](Point p) {
      EXPECT_GE(distance_to_edges(world, p, false), 4 - 1e-9) << algorithm;
    };
    along(result.path, keeps, false);
  }
}

// Two square corners, 5 apart, close the way to a margin of 2 unless they are well rounded.
TEST(Margin, LinesLeadThroughEveryPassage) {
  World world = empty_world(60, 45, Point{5, 22.5}, Point{55, 22.5});
  world.obstacles = {{{{10, 0}, {50, 0}, {30, 20}}, {}}, {{{10, 45}, {30, 25}, {50, 45}}, {}}};
  world.margin = 2;
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    const Result result = Planner(world).plan({}, Params(algorithm));
    ASSERT_EQ(result.status, Status::solved);
    ASSERT_FALSE(result.crossing.path.empty()) << "no line leads through";
    EXPECT_LE(result.length, 1.01 * *result.optimum);
  }
}

// Lines are drawn with fewer tangents around corners; no room is lost by it.
TEST(Margin, RoomBetweenACornerAndABoundaryThatIsKept) {
  World world;
  world.boundary.outer = {{11, -0.5}, {13, -0.5}, {13, 0.5}, {11, 0.5}};
  world.obstacles = {{{{0, 0}, {-20, 20}, {-20, -20}}, {}}};
  world.start = {11.2, 0};
  world.goal = {12.8, 0};
  const Planner planner(world, {.margin = 10, .boundary = Boundary::keep});
  for (const char* name : {"exact", "maklink-acs"}) {
    const Result r = planner.plan({}, Params(name));
    EXPECT_EQ(r.status, Status::solved) << name;
    EXPECT_NEAR(r.length, 1.6, 1e-9) << name;
  }
}

// Squares outside of it, 1 from each side.
TEST(Margin, LinesKeepItOfWhatIsBeyondABoundaryThatIsKept) {
  World world = empty_world(10, 10);
  for (const auto& [x, y] : {Point{4, -3}, {4, 11}, {-3, 4}, {11, 4}})
    world.obstacles.push_back({{{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}}, {}});
  const Planner planner(world, {.margin = 2, .boundary = Boundary::keep});
  const Point ends[][2] = {
      {{1, 0.5}, {9, 0.5}}, {{1, 9.5}, {9, 9.5}}, {{0.5, 1}, {0.5, 9}}, {{9.5, 1}, {9.5, 9}}};
  for (const auto& [start, goal] : ends) {
    const Result r = planner.plan({.start = start, .goal = goal}, Params("maklink-acs"));
    EXPECT_GE(r.length, (1 - 1e-9) * r.optimum.value()) << start.x << ' ' << start.y;
  }
}

TEST(Margin, NothingIsUnreachableThatADiscReaches) {
  int reached = 0;
  for (int i = 0; i < 12; ++i) {
    World world = random_world(static_cast<std::uint64_t>(600 + i), 10 + 30 * (i % 6));
    Dice dice(static_cast<std::uint64_t>(i));
    world.margin = dice.real(0.5, 6) / std::sqrt(1 + i % 6);
    const DiscBitmap discs(world, world.margin * 1.005, 0.4);
    const Planner planner(world);
    for (int k = 0; k < 14; ++k) {
      const Point start = discs.free_near({dice.real(0, 200), dice.real(0, 200)});
      const Point goal = discs.free_near({dice.real(0, 200), dice.real(0, 200)});
      EXPECT_TRUE(planner.free(start)) << i;
      if (!discs.joined(start, goal)) continue;
      for (const char* algorithm : {"exact", "maklink-acs"}) {
        Params parameters(algorithm);
        if (parameters.algorithm() != "exact") parameters.iterations = 1;
        const Result result = planner.plan({.start = start, .goal = goal}, parameters);
        EXPECT_EQ(result.status, Status::solved) << i << " " << k;
        EXPECT_EQ(result.crossing.path.empty(), parameters.algorithm() == "exact") << i;
      }
      ++reached;
    }
  }
  EXPECT_GT(reached, 100);
}

}  // namespace
}  // namespace lasius::polygon
