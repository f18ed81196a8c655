#include "core/tour/cover/near_ends.h"

#include <gtest/gtest.h>

#include <vector>

namespace lasius::tour {
namespace {

// Two rooms of three rows, a swath in each: linked through a door of the wall between, else not.
TEST(NearEnds, AreLinkedByMovesToCellsBeside) {
  const std::vector<Point> stops{{1.5, 1.5}, {8.5, 1.5}, {1.5, 5.5}, {8.5, 5.5}};
  for (const bool across : {false, true}) {
    for (const int door : {-1, 0, 9}) {
      Grid grid = across ? Grid(7, 10) : Grid(10, 7);
      for (int i = 0; i < 10; ++i) {
        if (i != door) grid.set_blocked(across ? Cell{3, i} : Cell{i, 3});
      }
      std::vector<Point> places = stops;
      if (across) {
        for (Point& p : places) p = {p.y, p.x};
      }
      const auto links = near_ends(grid, ToolLines(grid, 0), places);
      ASSERT_EQ(links.size(), door < 0 ? 0U : 1U) << across << door;
      if (door < 0) continue;
      EXPECT_EQ(links[0].a, door == 0 ? 0 : 1);
      EXPECT_EQ(links[0].b, door == 0 ? 2 : 3);
      EXPECT_GE(links[0].length, 4);
    }
  }
}

}  // namespace
}  // namespace lasius::tour
