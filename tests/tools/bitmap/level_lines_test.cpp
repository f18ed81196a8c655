#include "tools/bitmap/level_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/cost/level_values.h"
#include "lasius/cost/planner.h"

namespace lasius::tool {
namespace {

constexpr Point kAround[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

template <class Field>
CornerValues corners_of(int width, int height, const Field& field) {
  CornerValues corners;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      corners.cells.push_back({x, y});
      auto& values = corners.values.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) values[i] = field(x + kAround[i].x, y + kAround[i].y);
    }
  }
  return corners;
}

double length_of(const std::array<Point, 2>& piece) {
  return std::hypot(piece[1].x - piece[0].x, piece[1].y - piece[0].y);
}

TEST(LevelLines, OfALinearFieldAreStraightAndWhole) {
  const auto field = [](double x, double y) { return 3 * x + 4 * y; };
  std::map<int, double> length;
  for (const auto& piece : level_lines(corners_of(20, 15, field), 10)) {
    const double level = field(piece[0].x, piece[0].y) / 10;
    EXPECT_NEAR(level, std::round(level), 1e-12);
    EXPECT_NEAR(field(piece[1].x, piece[1].y) / 10, level, 1e-12);
    length[static_cast<int>(std::lround(level))] += length_of(piece);
  }
  ASSERT_EQ(length.size(), 11U);  // 10 to 110; 0 and 120 are single corners
  // 3 x + 4 y = 30 runs from (10, 0) to (0, 7.5), 60 from (20, 0) to (0, 15).
  EXPECT_NEAR(length.at(3), 12.5, 1e-9);
  EXPECT_NEAR(length.at(6), 25, 1e-9);
  EXPECT_NEAR(length.at(9), 12.5, 1e-9);
}

TEST(LevelLines, SaddlesAndFlatCellsHaveWholeLines) {
  CornerValues corners{.cells = {{2, 1}, {3, 1}}, .values = {{0, 1, 0, 1}, {4, 4, 4, 4}}};
  const auto lines = level_lines(corners, 0.5);  // of the first cell both 0.5; 1 is not passed
  ASSERT_EQ(lines.size(), 2U);
  for (const auto& piece : lines) EXPECT_NEAR(length_of(piece), std::sqrt(0.5), 1e-12);
  EXPECT_TRUE(level_lines({}, 1).empty());
}

/// Values bound costs from below, and lie near them: with k = 2 on every cell's edges.
TEST(LevelLines, OfEqualWeightsAreCirclesAboutTheGoal) {
  const Grid grid(60, 50);
  std::vector<double> weights(60 * 50, 2.0);
  weights[60 * 49] = 1;  // else the straight way is proof enough
  const CostField costs(60, 50, weights);
  const CostPlanner planner(Planner(grid), costs);
  const Request request{.start = {3, 4}, .goal = {50, 41}};
  const CostResult found = planner.plan(request, {.proof = true});
  ASSERT_TRUE(found.proof);
  const CornerValues corners = corner_values(*found.proof, grid);
  const auto widest = std::ranges::find(found.proof->levels, 1, &CostProof::Level::block);
  ASSERT_NE(widest, found.proof->levels.end());
  cost::LevelValues kept(*widest, 60, 50);
  ASSERT_FALSE(kept.read([](std::size_t) { return std::optional<std::string>(); }));
  ASSERT_EQ(corners.cells.size(), kept.cells().size());
  const double apart = 10;
  std::map<int, int> pieces;
  for (const auto& piece : level_lines(corners, apart)) {
    for (const Point at : piece) {
      const double cost = 2 * std::hypot(at.x - 50.5, at.y - 41.5);
      const double level = std::floor(cost / apart + 1e-9);
      EXPECT_LE(cost, 1.05 * level * apart + 0.5) << at.x << ", " << at.y;
      ++pieces[static_cast<int>(level)];
    }
  }
  // The way is 2 x 59.8 long.
  EXPECT_EQ(pieces.size(), static_cast<std::size_t>(corners.most / apart));
  EXPECT_GE(pieces.size(), 11U);
}

TEST(LevelLines, OfABrokenProofThereAreNone) {
  const Grid grid(8, 8);
  CostProof proof;
  EXPECT_TRUE(corner_values(proof, grid).cells.empty());
  proof.levels = {{.runs = {0, 0, 2}, .values = {1, 2, 3}}};
  EXPECT_TRUE(corner_values(proof, grid).cells.empty());
}

}  // namespace
}  // namespace lasius::tool
