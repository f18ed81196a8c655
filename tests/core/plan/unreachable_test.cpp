// What it takes to prove that a goal cannot be reached: the same on a map sixteen times as large,
// but for where the components' blocks lie in memory.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "lasius/plan/planner.h"
#include "tests/measures/count_pages.h"

namespace lasius {
namespace {

constexpr int kWall = 10100;
constexpr Cell kStart{9990, 300};    // in a tile that the wall parts
constexpr Cell kBeyond{10200, 800};  // in another one
constexpr Cell kShutIn{20300, 600};  // in a box in the middle of a tile

/// Open but for a wall from top to bottom, a box and a block in each of the tiles along the top. A
/// row takes more than a page, so that pages used tell rows and parts of rows apart.
Grid parted(int height) {
  Grid grid(Grid::kMaxSide, height);
  for (int y = 0; y < height; ++y) grid.set_blocked({kWall, y});
  for (int i = -5; i <= 5; ++i) {
    for (const int side : {-5, 5}) {
      grid.set_blocked({kShutIn.x + i, kShutIn.y + side});
      grid.set_blocked({kShutIn.x + side, kShutIn.y + i});
    }
  }
  for (int x = 100; x < grid.width(); x += 256) grid.set_blocked({x, 255});
  return grid;
}

std::vector<std::int64_t> pages_of_proofs(int height) {
  const Planner planner(parted(height));
  std::vector<std::int64_t> pages;
  for (const char* algorithm : {"fan2004", "as", "grid-ga", "exact"}) {
    const Params params(algorithm);
    for (const Cell goal : {kBeyond, kShutIn}) {
      Status status;
      {
        const PagesUsed used;
        status = planner.plan({.start = kStart, .goal = goal}, params).status;
        pages.push_back(used.count());
      }
      EXPECT_EQ(status, Status::unreachable);
    }
  }
  return pages;
}

TEST(Unreachable, AProofReadsAsMuchOnAMapSixteenTimesAsLarge) {
  const auto small = pages_of_proofs(1024);
  const auto large = pages_of_proofs(16 * 1024);
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_LE(std::abs(large[i] - small[i]), 8);
  // A page or two for each row of the tiles of start and goal, and a few of the components.
  for (const auto pages : small) {
    EXPECT_GT(pages, 0);
    EXPECT_LE(pages, 2 * (2 * 256 + 2) + 16);
  }
}

TEST(Unreachable, PagesAreCounted) {
  const Grid grid = parted(1024);
  const PagesUsed used;
  EXPECT_NE(grid.hash(), 0u);
  EXPECT_GE(used.count(), std::int64_t{grid.height()} * grid.words() * 8 / 4096);
  const auto all = used.count();
  EXPECT_NE(grid.hash(), 0u);
  EXPECT_EQ(used.count(), all);
}

}  // namespace
}  // namespace lasius
