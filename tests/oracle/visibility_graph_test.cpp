#include "tests/oracle/visibility_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/oracle/dense_dijkstra.h"
#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/shared_maps.h"

namespace lasius::oracle {
namespace {

// Dijkstra over all centres and all lattice points without diagonal blocks, where nothing can be
// squeezed through; every pair of them is an edge if its segment obeys the rule.
double all_pairs(const Grid& grid, Cell start, Cell goal) {
  std::vector<rule::HalfSegment> points;  // in ax, ay
  for (int y = 0; y <= 2 * grid.height(); ++y) {
    for (int x = y % 2; x <= 2 * grid.width(); x += 2) {
      const auto free = rule::free_around(grid, x / 2, y / 2);
      const bool diagonal = (free[0] == free[2]) && (free[1] == free[3]) && free[0] != free[1];
      if (y % 2 == 0 ? diagonal : grid.blocked({x / 2, y / 2})) continue;
      points.push_back({x, y, 0, 0});
    }
  }
  const auto is_at = [](Cell c) {
    return [c](const rule::HalfSegment& p) { return p.ax == 2 * c.x + 1 && p.ay == 2 * c.y + 1; };
  };
  std::vector<double> known(points.size(), kUnreached);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_at(start)(points[i])) known[i] = 0;
  }
  const auto between = [&](std::size_t a, std::size_t b) {
    return std::hypot(static_cast<double>(points[b].ax - points[a].ax),
                      static_cast<double>(points[b].ay - points[a].ay)) /
           2;
  };
  const auto joined = [&](std::size_t a, std::size_t b) {
    return rule::segment_obeys(grid, {points[a].ax, points[a].ay, points[b].ax, points[b].ay});
  };
  const auto end = std::ranges::find_if(points, is_at(goal)) - points.begin();
  return shortest_distances(std::move(known), between, joined)[end];
}

TEST(Oracle, KnowsALengthWorkedByHand) {
  const Grid grid = drawn({".....", ".###.", "....."});
  const auto way = VisibilityGraph(grid).shortest(Cell{0, 1}, Cell{4, 1});
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(way->path.size(), 4u);
  EXPECT_NEAR(way->length, 3 + 2 * std::sqrt(0.5), 1e-12);
  EXPECT_EQ(VisibilityGraph(grid).shortest(Cell{0, 1}, Cell{0, 1})->length, 0);
  EXPECT_FALSE(VisibilityGraph(grid).shortest(Cell{0, 1}, Cell{2, 1}));
}

TEST(Oracle, EqualsAllPairsOnSmallGrids) {
  std::mt19937 random(1);
  int unreachable = 0;
  int bends = 0;
  for (int round = 0; round < 3000; ++round) {
    const Grid grid =
        random_grid(random_in(1, 7, random), random_in(1, 7, random), 10 * (round % 6), random);
    const VisibilityGraph graph(grid);
    const Cell a = random_cell(grid, random), b = random_cell(grid, random);
    if (grid.blocked(a) || grid.blocked(b)) continue;
    const double truth = all_pairs(grid, a, b);
    const auto way = graph.shortest(a, b);
    ASSERT_EQ(way.has_value(), std::isfinite(truth));
    if (!way) {
      ++unreachable;
      continue;
    }
    ASSERT_NEAR(way->length, truth, 1e-9);
    ASSERT_TRUE(rule::Checker(grid).obeys(way->path));
    ASSERT_EQ(way->path.front(), centre(a));
    ASSERT_EQ(way->path.back(), centre(b));
    bends += static_cast<int>(way->path.size()) > 2;
  }
  EXPECT_GT(unreachable, 50);
  EXPECT_GT(bends, 80);
}

// The optima that come with the shared maps were found by other programs.
TEST(Oracle, AgreesWithTheSharedOptima) {
  if (bench_test::shared_tables().empty()) GTEST_SKIP() << bench_test::shared_dir();
  int checked = 0;
  for (const char* name : {"AR0300SR", "turtlebot3_world", "Boston_0_512", "w_woundedcoast",
                           "16room_001", "maze512-16-4"}) {
    const auto map =
        bench_test::load_shared(bench_test::shared_dir() / (std::string(name) + ".tsv"));
    const VisibilityGraph graph(map.grid);
    for (int i = 0; i < 5; ++i, ++checked) {
      const auto& q = map.queries.at(i);
      const auto way = graph.shortest(q.start, q.goal);
      ASSERT_TRUE(way.has_value()) << name << ' ' << i;
      EXPECT_NEAR(way->length, q.euclid, 1e-6) << name << ' ' << i;
      EXPECT_NEAR(graph.octile(q.start, q.goal), q.octile, 1e-6) << name << ' ' << i;
    }
  }
  EXPECT_EQ(checked, 30);
}

}  // namespace
}  // namespace lasius::oracle
