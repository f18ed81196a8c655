// Whether a footprint touches anything along a path, by separating axes at poses close together: a
// judge that shares no code with the library but `Grid`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::oracle {

/// One motion, told as results tell it: lengths in cells, angles in radians.
struct Motion {
  double x = 0, y = 0, yaw = 0;  ///< where it begins
  double curvature = 0;          ///< change of yaw for each cell driven forwards
  double length = 0;             ///< driven
  int gear = 1;                  ///< 1 forwards, -1 backwards, 0 in place
  double angle =
      0;            ///< of one in place; of a line: to the side it drives to, from the yaw it keeps
  double rate = 0;  ///< of the curvature, for each cell driven forwards
};

/// A pose that touches something.
struct Touch {
  std::size_t motion = 0;
  double x = 0, y = 0, yaw = 0;
  Cell cell{};
};

/// A simple polygon about the reference point, of any orientation, on a map. Squares are closed, so
/// is the footprint; outside of the map all is blocked.
class FootprintJudge {
 public:
  FootprintJudge(const Grid& grid, const std::vector<Point>& footprint);

  /// A blocked cell that is met deeper than 1e-9 cells.
  std::optional<Cell> touched(double x, double y, double yaw) const;
  /// The first of the poses that are at most `step` cells apart, or turned so far that no corner
  /// moves farther, ends of motions among them.
  std::optional<Touch> first_touch(std::span<const Motion> path, double step = 0.05);
  /// The pose after a share, 0 .. 1, of a motion, as {x, y, yaw}.
  static std::array<double, 3> pose_at(const Motion& motion, double share);

  std::int64_t poses() const { return poses_; }  ///< judged so far by first_touch

 private:
  using Triangle = std::array<Point, 3>;
  const Grid& grid_;
  std::vector<Triangle> triangles_;
  double reach_ = 0;  ///< of the farthest corner
  std::int64_t poses_ = 0;
};

}  // namespace lasius::oracle
