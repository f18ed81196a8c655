#include "lasius/eigen.h"

#include <gtest/gtest.h>

namespace lasius {
namespace {

TEST(Eigen, APathIsSeenWithoutACopy) {
  std::vector<Point> path{{0.5, 1.5}, {3.5, 5.5}, {4, 6}};
  const auto matrix = as_matrix(path);
  ASSERT_EQ(matrix.cols(), 3);
  EXPECT_EQ(static_cast<const void*>(matrix.data()), path.data());
  EXPECT_EQ(matrix.col(1), Eigen::Vector2d(3.5, 5.5));
  path[2].y = 7;
  EXPECT_EQ(matrix(1, 2), 7);
  EXPECT_DOUBLE_EQ((matrix.col(1) - matrix.col(0)).norm(), 5);
  EXPECT_EQ(as_matrix(std::span<const Point>()).cols(), 0);
}

TEST(Eigen, ThereAndBack) {
  const std::vector<Point> path{{0.5, 1.5}, {3.5, 5.5}, {4, 6}};
  EXPECT_EQ(as_points(as_matrix(path)), path);
  const Eigen::Matrix2Xd reversed = as_matrix(path).rowwise().reverse();
  EXPECT_EQ(as_points(reversed).front(), path.back());
  EXPECT_EQ(as_points(as_matrix(path).rightCols(2)).size(), 2u);
  EXPECT_TRUE(as_points(Eigen::Matrix2Xd()).empty());
}

}  // namespace
}  // namespace lasius
