#include "bench/peers/peers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bench/peers/anya.h"
#include "bench/peers/bucket_astar.h"
#include "bench/peers/segment.h"
#include "bench/peers/sight.h"
#include "lasius/path/path.h"
#include "tests/oracle/plane_rule.h"
#include "tests/oracle/visibility_graph.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/shared_maps.h"

namespace lasius::peers {
namespace {

Grid random_grid(int width, int height, double density, std::mt19937& random) {
  std::bernoulli_distribution blocked(density);
  return grid_of(width, height, [&](int, int) { return blocked(random); });
}

Cell random_free(const Grid& grid, std::mt19937& random) {
  for (;;) {
    const Cell c = random_cell(grid, random);
    if (grid.free(c)) return c;
  }
}

// By the rule of the plane; the ends are centres and corners of cells.
bool segment_free(const Grid& grid, Point p, Point q) {
  return rule::segment_obeys(grid, {std::lround(2 * p.x), std::lround(2 * p.y),
                                    std::lround(2 * q.x), std::lround(2 * q.y)});
}

void expect_valid(const Grid& grid, Cell start, Cell goal, const std::vector<Point>& path,
                  double length, std::string_view name) {
  ASSERT_FALSE(path.empty()) << name;
  EXPECT_EQ(path.front(), centre(start)) << name;
  EXPECT_EQ(path.back(), centre(goal)) << name;
  EXPECT_NEAR(length, path_length(path), 1e-9 * (1 + length)) << name;
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(segment_free(grid, path[i - 1], path[i]))
        << name << " segment " << i << " from " << path[i - 1].x << ',' << path[i - 1].y;
  }
}

TEST(Sight, AgreesWithTheRuleOfThePlaneOnRandomGrids) {
  std::mt19937 random(7);
  int clear = 0, hidden = 0;
  for (int round = 0; round < 400; ++round) {
    const Grid grid = random_grid(2 + round % 90, 2 + round % 11, 0.02 * (round % 12), random);
    if (grid.count_free() < 2) continue;
    for (int i = 0; i < 50; ++i) {
      const Cell a = random_free(grid, random), b = random_free(grid, random);
      const bool expected = segment_free(grid, centre(a), centre(b));
      ++(expected ? clear : hidden);
      ASSERT_EQ(clear_line(grid, a, b), expected)
          << round << ": " << a.x << ',' << a.y << " - " << b.x << ',' << b.y;
    }
  }
  EXPECT_GT(clear, 1000);
  EXPECT_GT(hidden, 1000);
}

TEST(Segment, IsClearOnlyWhereEveryPointOfItIsFree) {
  std::mt19937 random(9);
  int clear = 0, hidden = 0, stepped_over = 0;
  for (int round = 0; round < 200; ++round) {
    const Grid grid = random_grid(3 + round, 3 + round % 20, 0.01 * (round % 10), random);
    std::uniform_real_distribution<double> x(0, grid.width()), y(0, grid.height());
    for (int i = 0; i < 50; ++i) {
      const Point a{x(random), y(random)}, b{x(random), y(random)};
      bool all_free = true;
      for (int s = 0; s <= 4000; ++s) {
        const double t = s / 4000.0;
        all_free = all_free && grid.free({static_cast<int>(a.x + t * (b.x - a.x)),
                                          static_cast<int>(a.y + t * (b.y - a.y))});
      }
      const bool found = segment_clear(grid, a, b);
      ++(found ? clear : hidden);
      EXPECT_LE(found, all_free);
      stepped_over += !found && all_free;
    }
  }
  EXPECT_LT(stepped_over, 50);  // samples may miss a blocked corner
  EXPECT_GT(clear, 500);
  EXPECT_GT(hidden, 500);
}

TEST(Peers, FindTheOptimaOfSmallRandomGrids) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> side(2, 12);
  int reachable = 0, unreachable = 0;
  for (int round = 0; round < 6000; ++round) {
    const double density = (round % 8) * 0.07;
    const Grid grid = random_grid(side(random), side(random), density, random);
    if (grid.count_free() < 2) continue;
    const Cell start = random_free(grid, random);
    const oracle::VisibilityGraph graph(grid);
    std::vector<std::unique_ptr<QueryPlanner>> planners;
    for (const Peer& peer : all_peers()) planners.push_back(peer.make(grid));
    for (int i = 0; i < 4; ++i) {
      const Cell goal = random_free(grid, random);
      const auto shortest = graph.shortest(start, goal);
      const double optimum = shortest ? shortest->length : kNoPath;
      ++(optimum < kNoPath ? reachable : unreachable);
      for (std::size_t p = 0; p < planners.size(); ++p) {
        const Peer& peer = all_peers()[p];
        std::vector<Point> path = {{-1, -1}};
        const double length = planners[p]->plan(start, goal, path);
        if (optimum == kNoPath) {
          EXPECT_EQ(length, kNoPath) << peer.name;
          EXPECT_TRUE(path.empty()) << peer.name;
          continue;
        }
        expect_valid(grid, start, goal, path, length, peer.name);
        EXPECT_GE(length, optimum - 1e-9) << peer.name;
        if (peer.optimality == Optimality::octile) {
          EXPECT_NEAR(length, graph.octile(start, goal), 1e-9) << peer.name;
        } else if (peer.optimality == Optimality::any_angle) {
          EXPECT_NEAR(length, optimum, 1e-9) << peer.name;
        }
        if (testing::Test::HasFailure()) {
          FAIL() << "round " << round << ", " << start.x << ',' << start.y << " to " << goal.x
                 << ',' << goal.y;
        }
      }
    }
  }
  EXPECT_GT(reachable, 1000);
  EXPECT_GT(unreachable, 200);
}

TEST(Peers, FindTheOptimaOfLargerRandomGrids) {
  std::mt19937 random(2);
  for (int round = 0; round < 60; ++round) {
    const double density = round % 2 == 0 ? 0.025 * (round % 3) : 0.3 + 0.05 * (round % 4);
    const Grid grid = random_grid(40 + round, 100 - round, density, random);
    const Cell start = random_free(grid, random), goal = random_free(grid, random);
    const double octile = oracle::VisibilityGraph(grid).octile(start, goal);
    double exact = kNoPath;
    for (const Peer& peer : all_peers()) {
      std::vector<Point> path;
      const double length = peer.make(grid)->plan(start, goal, path);
      if (length == kNoPath) {
        EXPECT_GT(octile, 1e9) << peer.name;
        continue;
      }
      expect_valid(grid, start, goal, path, length, peer.name);
      if (peer.optimality == Optimality::octile) {
        EXPECT_NEAR(length, octile, 1e-6) << peer.name;
      }
      if (peer.optimality == Optimality::any_angle) exact = length;
      EXPECT_LE(length, octile + 1e-6) << peer.name;
    }
    if (exact < kNoPath) {
      EXPECT_LE(exact, octile);
    }
  }
}

TEST(BucketAStar, CoarsensItsCostsForVeryLongPaths) {
  // A snake of 2.1 million cells: longer than the finest integer costs can count.
  const int side = 2048;
  BucketAStar planner(snake(side));
  std::vector<Point> path;
  // 1024 free rows of 2047 steps, joined by 1023 ways down of two.
  const double expected = 1024.0 * (side - 1) + 2 * 1023;
  const double length = planner.plan({0, 0}, {0, side - 2}, path);
  EXPECT_NEAR(length, expected, 1e-3);
  EXPECT_EQ(planner.plan({0, 0}, {side - 1, 0}, path), side - 1);
}

class SharedPeers : public testing::TestWithParam<std::size_t> {};

TEST_P(SharedPeers, FindTheOptimaOfRealMaps) {
  const auto tables = bench_test::shared_tables();
  if (tables.empty()) GTEST_SKIP() << "no shared maps at " << bench_test::shared_dir();
  const Peer& peer = all_peers()[GetParam()];
  for (const auto& table : tables) {
    const bench_test::SharedMap map = bench_test::load_shared(table);
    const auto planner = peer.make(map.grid);
    // The slow ones answer one query in six; the exact one, and the octile optimum, all of them.
    const bool all = peer.name == "anya" || peer.name == "astar-bucket";
    for (std::size_t i = 0; i < map.queries.size(); i += all ? 1 : 6) {
      const bench_test::Query& q = map.queries[i];
      std::vector<Point> path;
      const double length = planner->plan(q.start, q.goal, path);
      EXPECT_NEAR(length, path_length(path), 1e-6);
      EXPECT_GE(length, q.euclid - 1e-6) << map.name;
      if (peer.optimality == Optimality::octile) {
        EXPECT_NEAR(length, q.octile, 1e-6) << map.name;
      }
      if (peer.optimality == Optimality::any_angle) {
        EXPECT_NEAR(length, q.euclid, 1e-6) << map.name;
      }
      if (peer.optimality == Optimality::none) {
        EXPECT_LE(length, q.octile + 1e-6) << map.name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, SharedPeers, testing::Range<std::size_t>(0, all_peers().size()),
                         [](const auto& param) {
                           std::string name(all_peers()[param.param].name);
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace lasius::peers
