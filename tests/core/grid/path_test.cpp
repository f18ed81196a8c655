#include "lasius/path/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using Path = std::vector<Point>;

TEST(PathLength, SumsTheSegments) {
  const Path path{{0.5, 0.5}, {3.5, 4.5}, {3.5, 5.5}};
  EXPECT_EQ(path_length(path), 6);
  EXPECT_EQ(path_length(std::span(path).first(1)), 0);
  EXPECT_EQ(path_length({}), 0);
}

// What is wrong with a path, or an empty text.
std::string fault(const Grid& grid, const Path& path, Corners corners = Corners::forbid) {
  return path_fault(grid, path, corners).value_or("");
}

TEST(PathFault, NamesTheFault) {
  const Grid grid = drawn({".....", ".##..", "..#..", ".#...", "....."});
  EXPECT_EQ(fault(grid, {{0.5, 0.5}, {4.5, 0.5}, {4.5, 4.5}}), "");
  EXPECT_EQ(fault(grid, {{0.5, 0.5}, {3, 1}, {3.5, 2.5}}), "");
  EXPECT_EQ(fault(grid, {}), "the path is empty");
  EXPECT_EQ(fault(grid, {{0.5, 0.5}, {0.5, 0.5}}), "");
  EXPECT_EQ(fault(grid, {{1.5, 1.5}}), "the only vertex (1.5, 1.5) touches no free cell");
  EXPECT_EQ(fault(grid, {{0.5, 0.5}, {5.5, 0.5}}), "vertex 1 (5.5, 0.5) is outside the map");
  EXPECT_EQ(fault(grid, {{0.5, 0.5}, {0.75, 0.5}, {0.5, 0.5}}),
            "vertex 1 (0.75, 0.5) is not at multiples of 0.5");
  EXPECT_EQ(fault(grid, {{std::nan(""), 0.5}}), "vertex 0 (nan, 0.5) is outside the map");
  EXPECT_EQ(fault(grid, {{0.5, 1.5}, {4.5, 1.5}}),
            "segment (0.5, 1.5) - (4.5, 1.5) enters the blocked cell (1, 1)");
  EXPECT_EQ(fault(grid, {{4.5, 1.5}, {0.5, 1.5}}),
            "segment (4.5, 1.5) - (0.5, 1.5) enters the blocked cell (2, 1)");
  EXPECT_EQ(fault(grid, {{2.5, 4.5}, {2.5, 0.5}}),
            "segment (2.5, 4.5) - (2.5, 0.5) enters the blocked cell (2, 2)");
  EXPECT_EQ(fault(grid, {{4.5, 4.5}, {0.5, 0.5}}),
            "segment (4.5, 4.5) - (0.5, 0.5) enters the blocked cell (2, 2)");
  EXPECT_EQ(fault(grid, {{2, 0.5}, {2, 2.5}}),
            "segment (2, 0.5) - (2, 2.5) runs between the blocked cells (1, 1) and (2, 1)");
  EXPECT_EQ(fault(grid, {{2, 2}, {2, 4}}),
            "segment (2, 2) - (2, 4) squeezes between the blocked cells (2, 2) and (1, 3)");
  EXPECT_EQ(fault(grid, {{1.5, 2.5}, {2.5, 3.5}}),
            "segment (1.5, 2.5) - (2.5, 3.5) squeezes between the blocked cells (2, 2) and (1, 3)");
  EXPECT_EQ(fault(grid, {{1.5, 2.5}, {2, 3}, {3.5, 3.5}}),
            "the path squeezes between blocked cells at (2, 3)");
}

TEST(PathFault, AllowsSqueezesWhenTold) {
  const Grid grid = drawn({"..#", ".#.", "..."});
  EXPECT_EQ(fault(grid, {{1.5, 0.5}, {2.5, 1.5}}, Corners::allow), "");
  EXPECT_EQ(fault(grid, {{1.5, 0.5}, {2, 1}, {2.5, 2.5}}, Corners::allow), "");
  EXPECT_EQ(fault(grid, {{2, 0}, {2, 2}}, Corners::allow), "");
  EXPECT_EQ(fault(grid, {{0.5, 1.5}, {1.5, 1.5}}, Corners::allow),
            "segment (0.5, 1.5) - (1.5, 1.5) enters the blocked cell (1, 1)");
  EXPECT_NE(fault(grid, {{1.5, 0.5}, {2.5, 1.5}}, Corners::one_side), "");
}

// Points that random paths bend at: mostly near each other, lattice points and centres.
Path random_path(const Grid& grid, std::mt19937& random) {
  Path path;
  int x = random_in(0, 2 * grid.width(), random);
  int y = random_in(0, 2 * grid.height(), random);
  for (int i = random_in(1, 4, random); i > 0; --i) {
    path.push_back({x / 2.0, y / 2.0});
    x = std::clamp(x + random_in(-4, 4, random), 0, 2 * grid.width());
    y = std::clamp(y + random_in(-4, 4, random), 0, 2 * grid.height());
  }
  return path;
}

TEST(PathFault, AgreesWithTheRuleOnRandomPaths) {
  std::mt19937 random(1);
  int valid = 0;
  int faulty = 0;
  for (int round = 0; round < 2000; ++round) {
    const Grid grid =
        random_grid(random_in(1, 8, random), random_in(1, 8, random), (round % 6) * 8, random);
    const rule::Checker checker(grid);
    for (int i = 0; i < 100; ++i) {
      const Path path = random_path(grid, random);
      // The rule wants the cell right below a lone vertex to be free.
      bool lone = true;
      for (const Point p : path) lone = lone && p == path[0];
      if (lone) continue;
      const auto got = path_fault(grid, path);
      ASSERT_EQ(!got.has_value(), rule::path_obeys(grid, path)) << got.value_or("no fault");
      ASSERT_EQ(!got.has_value(), checker.obeys(path)) << got.value_or("no fault");
      (got ? faulty : valid) += 1;
      ASSERT_TRUE(got || !path_fault(grid, path, Corners::allow));
    }
  }
  EXPECT_GT(valid, 20000);
  EXPECT_GT(faulty, 20000);
}

TEST(PathFault, AllowedSqueezesAreTheOnlyDifference) {
  std::mt19937 random(2);
  int differ = 0;
  for (int round = 0; round < 3000; ++round) {
    const Grid grid = random_grid(6, 6, 15, random);
    const Path path = random_path(grid, random);
    const auto strict = path_fault(grid, path);
    if (strict == path_fault(grid, path, Corners::allow)) continue;
    ++differ;
    ASSERT_TRUE(strict.has_value());
    ASSERT_NE(strict->find("squeezes"), std::string::npos) << *strict;
  }
  EXPECT_GT(differ, 10);
}

}  // namespace
}  // namespace lasius
