#include "core/exact/prepared_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/exact/exact.h"
#include "lasius/grid/generate.h"
#include "tests/core/exact/exact_answers.h"

namespace lasius {
namespace {

using exact::CornerGraph;
using exact::PreparedSearch;
using Graph = std::shared_ptr<const CornerGraph>;

ExactAnswer solve(PreparedSearch& search, const Grid& grid, const Graph& graph, Cell start,
                  Cell goal, const ExactOptions& options = {}, const StopCondition& stop = {}) {
  ExactAnswer answer;
  search.search(grid, *graph, centre(start), centre(goal), options, stop, answer);
  return answer;
}

// Plans between random cells; the answers equal the optima by brute force. Counts those with a
// path.
int expect_exact(const Grid& grid, int queries, PreparedSearch& search, std::mt19937& random) {
  const Graph graph = graph_of(grid);
  int reachable = 0;
  for (int i = 0; i < queries && !testing::Test::HasFailure(); ++i) {
    const auto start = random_free(grid, random);
    const auto goal = random_free(grid, random);
    if (!start || !goal) continue;
    reachable += expect_optimum(grid, *start, *goal, solve(search, grid, graph, *start, *goal));
  }
  return reachable;
}

TEST(PreparedSearch, EqualsBruteForceOnRandomGrids) {
  std::mt19937 random(20260111);
  PreparedSearch search;
  int small = 0, large = 0, sparse = 0;
  for (int i = 0; i < scaled(1500) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("grid " + std::to_string(i));
    small += expect_exact(random_small_grid(i, random), 4, search, random);
    if (i % 25 != 0) continue;
    large += expect_exact(random_large_grid(i / 25, random), 5, search, random);
    sparse += expect_exact(random_sparse_grid(i % 2 == 0, random), 1, search, random);
  }
  EXPECT_GT(small, 2000);
  EXPECT_GT(large, 100);
  EXPECT_GT(sparse, 40);
}

TEST(PreparedSearch, EqualsTheUnpreparedOneOnGeneratedMaps) {
  std::mt19937 random(20260113);
  PreparedSearch search;
  ExactSearch unprepared;
  int reachable = 0;
  for (std::size_t k = 0; k < map_kind_names().size(); ++k) {
    SCOPED_TRACE(map_kind_names()[k]);
    const Grid grid = generate(static_cast<MapKind>(k), {400, 300, -1, 7});
    const Graph graph = graph_of(grid);
    for (int i = 0; i < 40; ++i) {
      const Cell start = *random_free(grid, random), goal = *random_free(grid, random);
      reachable +=
          expect_unprepared(grid, start, goal, unprepared, solve(search, grid, graph, start, goal));
    }
  }
  EXPECT_GT(reachable, 150);
}

TEST(PreparedSearch, KnowsWhatHasNoCornersOrNoWay) {
  PreparedSearch search;
  const Grid open(20, 10);
  EXPECT_DOUBLE_EQ(solve(search, open, graph_of(open), {1, 1}, {13, 6}).length, 13);
  const ExactAnswer still = solve(search, open, graph_of(open), {1, 1}, {1, 1});
  EXPECT_TRUE(still.optimal);
  EXPECT_EQ(still.length, 0);
  for (const Grid& shut : {drawn({".#", "#."}), drawn({".#.#", "#..#", "...."})}) {
    const ExactAnswer none = solve(search, shut, graph_of(shut), {0, 0}, {1, 1});
    EXPECT_EQ(none.end, ExactEnd::unreachable);
    EXPECT_TRUE(std::isinf(none.lower_bound));
  }
}

// On a map where paths seldom leave the straight line, searches keep near it at first.
TEST(PreparedSearch, LooksFurtherWhereNothingNearIsShort) {
  std::mt19937 random(19);
  Grid grid = random_grid(240, 200, 2, random);
  for (int k = 0; k < 12; ++k) {  // a trap, open to the left
    grid.set_blocked({82, 70 + k});
    grid.set_blocked({71 + k, 70});
    grid.set_blocked({71 + k, 81});
  }
  const Graph graph = graph_of(grid);
  ASSERT_LT(graph->detour(), 1.01);
  PreparedSearch search;
  int far = 0;
  for (int i = 0; i < 40; ++i) {
    const Cell start{76 + i % 6, 72 + i % 9}, goal{84 + i % 20, 75};
    if (grid.blocked(start) || grid.blocked(goal)) continue;
    const ExactAnswer answer = solve(search, grid, graph, start, goal);
    if (expect_optimum(grid, start, goal, answer)) far += answer.length > goal.x - start.x + 3;
    const ExactAnswer back = solve(search, grid, graph, goal, start);
    EXPECT_NEAR(back.length, answer.length, 1e-9 * answer.length);
  }
  EXPECT_GT(far, 20);
}

class PreparedSearchStop : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Densities, PreparedSearchStop, testing::Values(5, 33));

TEST_P(PreparedSearchStop, BoundsHoldWheneverItComes) {
  std::mt19937 random(16);
  Grid grid = random_grid(400, 400, GetParam(), random);
  const Cell start{2, 2}, goal{397, 397};
  grid.fill({0, 0, 6, 6}, false);
  grid.fill({394, 394, 6, 6}, false);
  const Graph graph = graph_of(grid);
  PreparedSearch search;
  const Stops stops = expect_bounds_at_stops(grid, start, goal, [&](const StopCondition& stop) {
    return solve(search, grid, graph, start, goal, {}, stop);
  });
  EXPECT_GT(stops.stopped, 0);
}

// Told only where it is the one that the ordinary search finds, on maps of many ties, too; and at
// once where nothing is symmetric.
TEST(PreparedSearch, TellsTheOnlyPath) {
  std::mt19937 random(11);
  PreparedSearch search;
  ExactSearch plain;
  int told = 0, asked = 0;
  for (int i = 0; i < 300; ++i) {
    const Grid grid = i % 2 == 0 ? random_small_grid(i, random) : random_large_grid(i, random);
    const Graph graph = graph_of(grid);
    for (int k = 0; k < 20; ++k) {
      const auto start = random_free(grid, random);
      const auto goal = random_free(grid, random);
      if (!start || !goal) break;
      ExactAnswer only;
      const ExactAnswer expected = lasius::solve(plain, grid, *start, *goal);
      const bool found = search.search_only(grid, *graph, centre(*start), centre(*goal), {}, only);
      asked += expected.path.empty() ? 0 : 1;
      if (!found) continue;
      ++told;
      ASSERT_EQ(only.path, expected.path);
      EXPECT_EQ(only.length, expected.length);
      EXPECT_EQ(only.lower_bound, expected.lower_bound);
      EXPECT_EQ(only.optimal, expected.optimal);
    }
  }
  EXPECT_GT(told, asked / 2);
  EXPECT_LE(told, asked);
}

// Around a block in the middle there are two ways, as short.
TEST(PreparedSearch, TellsNoPathOfTwo) {
  Grid grid(9, 9);
  grid.fill({3, 3, 3, 3}, true);
  const Graph graph = graph_of(grid);
  PreparedSearch search;
  ExactAnswer answer;
  const auto told = [&](Cell start, Cell goal) {
    return search.search_only(grid, *graph, centre(start), centre(goal), {}, answer);
  };
  EXPECT_FALSE(told({0, 4}, {8, 4}));
  EXPECT_FALSE(told({1, 1}, {7, 7}));
  EXPECT_TRUE(told({0, 3}, {8, 3}));
  EXPECT_TRUE(told({0, 0}, {8, 0}));
  EXPECT_EQ(answer.path.size(), 2U);
}

// On both sides of a block ways lead to a corner behind it, as short; no search keeps those.
TEST(PreparedSearch, ForgetsTheWaysOfEarlierSearches) {
  Grid grid(200, 200);
  grid.set_blocked({50, 50});
  grid.fill({150, 140, 1, 10}, true);
  const Graph graph = graph_of(grid);
  ASSERT_LT(graph->detour(), 1.01);
  PreparedSearch search;
  ExactAnswer answer;
  std::int64_t bytes = 0;
  for (int i = 0; i < 9; ++i) {
    EXPECT_FALSE(
        search.search_only(grid, *graph, centre({10, 10}), centre({151, 149}), {}, answer));
    if (i == 0) bytes = search.bytes();
  }
  EXPECT_EQ(search.bytes(), bytes);
}

}  // namespace
}  // namespace lasius
