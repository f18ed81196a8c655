// Corners of a way rounded by parabolas.
#pragma once

#include <span>
#include <vector>

#include "lasius/arm/robot.h"

namespace lasius::arm {

/// A piece of a path: q(s) = start + s along + s^2 / 2 bend, s from 0 to `length`; |along| is 1,
/// and so is |dq/ds| at its end. What is straight has no bend.
struct PathPiece {
  JointVector start, along, bend;
  double length = 0;

  bool straight() const { return bend.size() == 0; }
  JointVector at(double s) const { return start + s * direction(0.5 * s); }
  /// dq/ds.
  JointVector direction(double s) const {
    JointVector rate = along;
    if (!straight()) rate += s * bend;
    return rate;
  }
};

/// A path from rest to rest; dq/ds goes on from each piece to the next.
using PathRun = std::vector<PathPiece>;

/// The parabola about corner `i` of the way: it leaves one edge `size` before the corner, and meets
/// the other as far behind it. A quadratic Bezier curve with the corner in its middle, so within
/// the limits of the joints where the way is. Precondition: 0 < i < way.size() - 1, size > 0.
PathPiece blend_at(const std::vector<JointVector>& way, std::size_t i, double size);

/// How large that may be: half of the shorter edge beside the corner.
double largest_blend(const std::vector<JointVector>& way, std::size_t i);

/// The way with a parabola at each corner, `sizes` by place in the way, and edges between; a run
/// ends where a size is 0. Precondition: no point is like the one before.
std::vector<PathRun> rounded(const std::vector<JointVector>& way, std::span<const double> sizes);

}  // namespace lasius::arm
