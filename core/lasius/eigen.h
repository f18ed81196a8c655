// Paths as Eigen matrices; needs Eigen 3 and no library but lasius itself.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius {

static_assert(std::is_standard_layout_v<Point> && sizeof(Point) == 2 * sizeof(double) &&
                  offsetof(Point, x) == 0 && offsetof(Point, y) == sizeof(double),
              "a Point is its two coordinates, one after the other");

/// The points as a matrix, a column (x, y) each, not copied: in cells, y downwards, for a path on a
/// bitmap, in the world's unit among polygons. Valid as long as the points stay where they are.
inline Eigen::Map<const Eigen::Matrix2Xd> as_matrix(std::span<const Point> points) noexcept {
  return {reinterpret_cast<const double*>(points.data()), 2,
          static_cast<Eigen::Index>(points.size())};
}
/// A path that nobody keeps would be gone with the statement.
void as_matrix(std::vector<Point>&& points) = delete;

/// The columns (x, y) of a matrix as points, copied.
/// @throws std::bad_alloc.
inline std::vector<Point> as_points(const Eigen::Ref<const Eigen::Matrix2Xd>& matrix) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(matrix.cols()));
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) points.push_back({matrix(0, i), matrix(1, i)});
  return points;
}

}  // namespace lasius
