#include "core/exact/exact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lasius/grid/generate.h"
#include "tests/core/exact/exact_answers.h"

namespace lasius {
namespace {

ExactAnswer solve(const Grid& grid, Cell start, Cell goal, const ExactOptions& options = {}) {
  ExactSearch search;
  return solve(search, grid, start, goal, options);
}

// Searches; the answer equals the optimum by brute force. True if there is a path.
bool expect_exact(const Grid& grid, Cell start, Cell goal, ExactSearch& search) {
  return expect_optimum(grid, start, goal, solve(search, grid, start, goal));
}

TEST(Exact, SeesStraightToTheGoal) {
  const Grid grid(20, 10);
  const auto answer = solve(grid, {1, 1}, {13, 6});
  EXPECT_EQ(answer.end, ExactEnd::proven);
  EXPECT_DOUBLE_EQ(answer.length, 13);
  EXPECT_EQ(answer.path, (std::vector<Point>{{1.5, 1.5}, {13.5, 6.5}}));
}

TEST(Exact, StartIsGoal) {
  const auto answer = solve(Grid(3, 3), {1, 1}, {1, 1});
  EXPECT_TRUE(answer.optimal);
  EXPECT_EQ(answer.length, 0);
  EXPECT_EQ(answer.lower_bound, 0);
}

TEST(Exact, BendsAroundAWall) {
  const Grid grid = drawn({"...#...", "...#...", "...#...", "...#...", "......."});
  const auto answer = solve(grid, {1, 1}, {5, 1});
  EXPECT_EQ(answer.path, (std::vector<Point>{{1.5, 1.5}, {3, 4}, {4, 4}, {5.5, 1.5}}));
  EXPECT_DOUBLE_EQ(answer.length, 1 + 2 * std::sqrt(1.5 * 1.5 + 2.5 * 2.5));
}

TEST(Exact, DoesNotSqueezeBetweenDiagonalBlocks) {
  EXPECT_EQ(solve(drawn({".#", "#."}), {0, 0}, {1, 1}).end, ExactEnd::unreachable);
  const Grid grid = drawn({".#.", "#..", "..."});
  ExactSearch search;
  ExactAnswer answer = solve(search, grid, {1, 1}, {2, 2});
  EXPECT_EQ(answer.path.size(), 2u);
  search.search(grid, centre({0, 0}), centre({2, 2}), {}, {}, answer);
  EXPECT_EQ(answer.end, ExactEnd::unreachable);
  EXPECT_TRUE(answer.path.empty());  // that of before is gone
}

TEST(Exact, SlidesAlongEdgesAndStraightPastCorners) {
  // Every corner of the middle row's blocks lies on one horizontal line with the path.
  const Grid grid = drawn({".......", ".#.#.#.", "......."});
  std::mt19937 random(3);
  ExactSearch search;
  for (int x = 0; x < 7; x += 2) {
    for (int y = 0; y < 3; ++y) expect_exact(grid, {x, y}, {6, 1}, search);
  }
}

struct Counts {
  int reachable = 0, unreachable = 0;
};

// Searches between two random cells on each of so many grids, `make(number, random)`.
Counts expect_exact(int grids, unsigned seed, Grid (*make)(int number, std::mt19937& random)) {
  std::mt19937 random(seed);
  ExactSearch search;
  Counts counts;
  for (int i = 0; i < scaled(grids) && !testing::Test::HasFailure(); ++i) {
    const Grid grid = make(i, random);
    const auto start = random_free(grid, random);
    const auto goal = random_free(grid, random);
    if (!start || !goal) continue;
    SCOPED_TRACE("grid " + std::to_string(i));
    ++(expect_exact(grid, *start, *goal, search) ? counts.reachable : counts.unreachable);
  }
  return counts;
}

// LASIUS_EXACT_GRIDS=25 makes 100 000 small and 10 000 large queries.
TEST(Exact, EqualsBruteForceOnSmallGrids) {
  const Counts counts = expect_exact(4000, 20260101, random_small_grid);
  EXPECT_GT(counts.reachable, 1000);
  EXPECT_GT(counts.unreachable, 300);
}

TEST(Exact, EqualsBruteForceOnLargerGrids) {
  EXPECT_GT(expect_exact(400, 20260102, random_large_grid).reachable, 200);
}

// Long views between few blocks, where scans keep to strips and boxes.
TEST(Exact, EqualsBruteForceInWideSparseGrids) {
  const auto sparse = [](int number, std::mt19937& random) {
    return random_sparse_grid(number % 2 == 0, random);
  };
  EXPECT_GT(expect_exact(60, 20260103, sparse).reachable, 40);
}

// The search that goes first answers where the shortest path is the only one, with that of the
// other, which runs alone where somebody looks on.
TEST(Exact, TheSearchThatGoesFirstChangesNoPath) {
  std::mt19937 random(12);
  ExactSearch whole;
  const OnImproved look = [](const std::vector<Point>&, double, double) { return true; };
  int only = 0, tied = 0;
  for (int i = 0; i < 3000; ++i) {
    const Grid grid = i % 3 == 0 ? random_large_grid(i, random) : random_small_grid(i, random);
    const auto start = random_free(grid, random), goal = random_free(grid, random);
    if (!start || !goal) continue;
    ExactSearch search;
    const ExactAnswer answer = solve(search, grid, *start, *goal);
    EXPECT_EQ(answer.path, solve(whole, grid, *start, *goal, {.improved = &look}).path);
    EXPECT_EQ(whole.counters().ties, exact::Counters::Ties::unknown);
    only += search.counters().ties == exact::Counters::Ties::none ? 1 : 0;
    tied += search.counters().ties == exact::Counters::Ties::some ? 1 : 0;
  }
  EXPECT_GT(only, 500);
  EXPECT_GT(tied, 20);
}

TEST(Exact, SaysWhereAnotherPathIsAsShort) {
  const Grid grid = drawn({".......", "..###..", "..###..", "..###..", "......."});
  ExactSearch search;
  EXPECT_EQ(solve(search, grid, {1, 2}, {5, 2}).path.size(), 4);  // one way round of two
  EXPECT_EQ(search.counters().ties, exact::Counters::Ties::some);
  ExactSearch other;
  EXPECT_EQ(solve(other, grid, {1, 1}, {5, 2}).path.size(), 4);
  EXPECT_EQ(other.counters().ties, exact::Counters::Ties::none);
}

TEST(Exact, AnyPathWillDoWithAnUnboundedGap) {
  std::mt19937 random(8);
  ExactSearch search;
  for (const double gap : {1e300, std::numeric_limits<double>::infinity()}) {
    const Grid grid = generate(MapKind::maze, {300, 300, -1, 2});
    const Cell start = *random_free(grid, random), goal = *random_free(grid, random);
    const ExactAnswer answer = solve(search, grid, start, goal, {gap});
    EXPECT_EQ(answer.end, ExactEnd::target_gap);
    EXPECT_LE(answer.lower_bound, answer.length);
    expect_path(grid, start, goal, answer);
  }
}

// In words, a fiftieth more than it took: a worse order, or a farther look, changes no answer.
TEST(Exact, TakesNoMoreWorkThanItDid) {
  ExactSearch search;
  for (const auto& [gap, most] : {std::pair{0.0, 28'650}, {0.02, 30'130}}) {
    std::mt19937 random(21);
    std::int64_t words = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Grid grid =
          generate(seed % 2 == 0 ? MapKind::maze : MapKind::blobs, {300, 300, -1, seed});
      const Cell start = *random_free(grid, random), goal = *random_free(grid, random);
      solve(search, grid, start, goal, {gap});
      words += search.counters().words;
    }
    EXPECT_LE(words, most) << "gap " << gap;
  }
}

TEST(Exact, PathsTooLongForTheRoundingAreNotCalledOptimal) {
  const auto concluded = [](double length) {
    ExactAnswer answer;
    answer.path = {{0, 0}, {length, 0}};
    exact::conclude(length, length, StopCondition::Cause::none, 0, answer);
    EXPECT_EQ(answer.end, ExactEnd::proven);
    return answer;
  };
  const ExactAnswer shorter = concluded(0x1p22);
  EXPECT_TRUE(shorter.optimal);
  EXPECT_EQ(shorter.lower_bound, 0x1p22);
  const ExactAnswer longer = concluded(0x1p26);
  EXPECT_FALSE(longer.optimal);
  EXPECT_EQ(longer.lower_bound, 0x1p26 - 1);  // 2^26 additions, each off by up to 2^-27
}

}  // namespace
}  // namespace lasius
