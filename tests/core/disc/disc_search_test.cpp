#include "core/disc/disc_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/disc/disc_worlds.h"
#include "tests/oracle/disc_paths.h"

namespace lasius::disc {
namespace {

DiscAnswer solve(DiscSearch& search, const DiscSpace& space, Point start, Point goal) {
  DiscAnswer answer;
  search.search(space, start, goal, {}, {}, answer);
  return answer;
}

TEST(DiscSearch, EqualsBruteForceOnSmallMaps) {
  std::mt19937 random(1);
  DiscSearch search;
  int found = 0, closed = 0, bent = 0;
  for (int round = 0; round < scaled(100); ++round) {
    const double radius = random_radius(round % 4 == 0 ? 5 : 2, random);
    const Grid grid = random_map(radius, random);
    const auto space = DiscSpace::make(grid, radius);
    oracle::DiscPaths paths(grid, radius);
    for (int i = 0; i < 4; ++i) {
      const auto start = random_clear(*space, random), goal = random_clear(*space, random);
      if (!start || !goal) continue;
      ASSERT_TRUE(paths.clear(*start));
      const auto expected = paths.shortest(*start, *goal);
      const DiscAnswer answer = solve(search, *space, *start, *goal);
      SCOPED_TRACE(testing::Message() << "round " << round << " radius " << radius << " from "
                                      << start->x << ' ' << start->y << " to " << goal->x << ' '
                                      << goal->y);
      if (!expected) {
        ++closed;
        EXPECT_EQ(answer.end, ExactEnd::unreachable);
        continue;
      }
      ++found;
      bent += answer.curve.size() > 1;
      EXPECT_EQ(answer.end, ExactEnd::proven);
      EXPECT_NEAR(answer.length, *expected, 1e-9);
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(closed, 10);
  EXPECT_GT(bent, 50);
}

}  // namespace
}  // namespace lasius::disc
