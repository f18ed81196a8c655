// Lasius as an entry of the Grid-Based Path Planning Competition.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bench/competition/entry.h"
#include "tests/core/base/made_files.h"

namespace lasius::bench {
namespace {

// 20 x 12, with a block of 4 x 6.
std::vector<bool> block() {
  std::vector<bool> bits;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x) bits.push_back(!(x >= 8 && x < 12 && y >= 2 && y < 8));
  return bits;
}

void expect_answers(void* map) {
  std::vector<xyLoc> path;
  EXPECT_TRUE(GetPath(map, {1, 6}, {18, 6}, path));
  ASSERT_EQ(path.size(), 4);
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  EXPECT_NEAR(length, std::hypot(7, 2) + 4 + std::hypot(6, 2), 1e-12);
  EXPECT_EQ(path[1].x, 8);
  EXPECT_EQ(path[1].y, 8);
  EXPECT_TRUE(GetPath(map, {3, 3}, {3, 3}, path));
  EXPECT_TRUE(path.empty());
}

class CompetitionFiles : public Files {};

TEST_F(CompetitionFiles, AnswersWithAFileAndWithout) {
  const std::string file = path("map.prepared");
  expect_answers(PrepareForSearch(block(), 20, 12, file));
  PreprocessMap(block(), 20, 12, file);
  ASSERT_TRUE(fs::exists(file));
  expect_answers(PrepareForSearch(block(), 20, 12, file));
}

TEST(Competition, AGoalThatCannotBeReachedHasNoPath) {
  std::vector<bool> bits = block();
  for (int y = 0; y < 12; ++y) bits[static_cast<std::size_t>(y) * 20 + 15] = false;
  void* const map = PrepareForSearch(bits, 20, 12, "");
  std::vector<xyLoc> path{{1, 1}};
  EXPECT_TRUE(GetPath(map, {1, 6}, {18, 6}, path));
  EXPECT_TRUE(path.empty());
}

}  // namespace
}  // namespace lasius::bench
