#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "core/exact/exact.h"
#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/exact/exact_answers.h"
#include "tests/measures/count_allocations.h"

namespace lasius {
namespace {

constexpr std::int64_t kAnyWork = std::numeric_limits<std::int64_t>::max();

// The free cells around each lattice point that a path meets.
void add_corners(const Grid& grid, const std::vector<Point>& path, CellSet& cells) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1], b = path[i];
    const int dx = static_cast<int>(2 * (b.x - a.x)), dy = static_cast<int>(2 * (b.y - a.y));
    const int parts = std::gcd(dx, dy);
    for (int part = 0; part <= parts; ++part) {
      const double x = a.x + 0.5 * (dx / parts * part), y = a.y + 0.5 * (dy / parts * part);
      if (x != std::floor(x) || y != std::floor(y)) continue;
      for (const int k : {0, 1, 2, 3}) {
        const Cell c{static_cast<int>(x) - k % 2, static_cast<int>(y) - k / 2};
        if (grid.contains(c) && grid.free(c)) cells.add(c);
      }
    }
  }
}

bool bends_at(const CellSet& cells, const std::vector<Point>& path) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (!cells.touches(static_cast<int>(path[i].x), static_cast<int>(path[i].y))) return false;
  }
  return true;
}

TEST(Shortcut, BendsOnlyWhereTheCellsTouchACorner) {
  // Over the wall it is shorter than under it.
  const Grid grid = drawn({".......", "...#...", "...#...", "...#...", "...#...", "......."});
  ExactSearch search;
  std::vector<Point> path;
  CellSet cells;
  cells.reset(4);
  search.shortcut(grid, {1, 2}, {5, 2}, 100, cells, kAnyWork, {}, path);
  EXPECT_TRUE(path.empty());
  cells.add({2, 5});
  cells.add({4, 5});
  search.shortcut(grid, {1, 2}, {5, 2}, 100, cells, kAnyWork, {}, path);
  EXPECT_EQ(path, (std::vector<Point>{{1.5, 2.5}, {3, 5}, {4, 5}, {5.5, 2.5}}));
  cells.add({3, 0});
  search.shortcut(grid, {1, 2}, {5, 2}, 100, cells, kAnyWork, {}, path);
  EXPECT_EQ(path, (std::vector<Point>{{1.5, 2.5}, {3, 1}, {4, 1}, {5.5, 2.5}}));
  search.shortcut(grid, {1, 2}, {5, 2}, path_length(path), cells, kAnyWork, {}, path);
  EXPECT_TRUE(path.empty());
  search.shortcut(grid, {1, 2}, {2, 4}, 100, cells, kAnyWork, {}, path);
  EXPECT_EQ(path, (std::vector<Point>{{1.5, 2.5}, {2.5, 4.5}}));
}

TEST(Shortcut, FindsAShortestPathWhoseCornersAreTouched) {
  std::mt19937 random(5);
  ExactSearch search, whole;
  CellSet cells;
  std::vector<Point> path;
  int found = 0, others = 0;
  for (int i = 0; i < 6000; ++i) {
    const Grid grid = i % 3 == 0 ? random_large_grid(i, random) : random_small_grid(i, random);
    const auto start = random_free(grid, random), goal = random_free(grid, random);
    if (!start || !goal) continue;
    const ExactAnswer answer = solve(whole, grid, *start, *goal);
    if (!answer.optimal || answer.path.size() < 3) continue;
    cells.reset(16);
    const auto enter = [&](int percent) {
      for (const Cell c : cells_of(grid)) {
        if (grid.free(c) && random_in(0, 99, random) < percent) cells.add(c);
      }
    };
    enter(random_in(0, 30, random));
    search.shortcut(grid, *start, *goal, 1e6, cells, kAnyWork, {}, path);
    if (!path.empty()) {
      ++others;
      EXPECT_GE(path_length(path), answer.length * (1 - exact::kRounding));
      EXPECT_FALSE(path_fault(grid, path).has_value());
      EXPECT_TRUE(bends_at(cells, path));
    }
    add_corners(grid, answer.path, cells);
    search.shortcut(grid, *start, *goal, answer.length * 1.001, cells, kAnyWork, {}, path);
    ASSERT_FALSE(path.empty());
    EXPECT_NEAR(path_length(path), answer.length, exact::kRounding * answer.length);
    EXPECT_TRUE(bends_at(cells, path));
    ++found;
    // The search forgets which corners it was to use.
    EXPECT_EQ(solve(search, grid, *start, *goal).path, answer.path);
  }
  EXPECT_GT(found, 1500);
  EXPECT_GT(others, 500);
}

class LongShortcut : public testing::Test {
 protected:
  static constexpr Cell kStart{20, 10}, kGoal{580, 480};

  LongShortcut() {
    for (const Cell c : {kStart, kGoal}) grid_.set_blocked(c, false);
    cells_.reset(1);
    for (const Cell c : cells_of(grid_)) cells_.add(c);
  }
  std::vector<Point> shortcut(std::int64_t work, const StopCondition& stop = {}) {
    std::vector<Point> path;
    search_.shortcut(grid_, kStart, kGoal, 2000, cells_, work, stop, path);
    return path;
  }

  Grid grid_ = generate(MapKind::random, {600, 500, -1, 4});
  CellSet cells_;
  ExactSearch search_;
};

TEST_F(LongShortcut, EndsAfterSoMuchWork) {
  const auto path = shortcut(kAnyWork);
  ASSERT_GT(path.size(), 2u);
  const auto words_in_all = search_.counters().words;
  for (const std::int64_t work : {0, 1000, 20000}) {
    EXPECT_TRUE(shortcut(work).empty()) << work;
    const auto& done = search_.counters();
    EXPECT_LT(done.words, words_in_all);
    // The last corner is left whatever it takes.
    EXPECT_LE(exact::kWordsPerExpansion * (done.expansions - 1), work);
  }
}

TEST_F(LongShortcut, PollsAndReturnsAValidPathOrNoneWhenStopped) {
  const CountingTime counted(1 << 30);
  const auto path = shortcut(kAnyWork, counted.is_up());
  ASSERT_GT(counted.polls(), 8);
  for (int looks = 0; looks < counted.polls(); looks += 3) {
    const CountingTime up(looks);
    const auto cut = shortcut(kAnyWork, up.is_up());
    EXPECT_EQ(up.polls(), looks + 1);
    EXPECT_TRUE(cut.empty() || cut == path);
  }
}

TEST_F(LongShortcut, AllocatesNothingTheSecondTime) {
  shortcut(kAnyWork);
  std::vector<Point> path;
  path.reserve(1000);
  const std::int64_t before = allocations;
  search_.shortcut(grid_, kStart, kGoal, 2000, cells_, kAnyWork, {}, path);
  EXPECT_EQ(allocations, before);
  EXPECT_FALSE(path.empty());
}

}  // namespace
}  // namespace lasius
