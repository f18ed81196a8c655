// How far a view looks for paths that are shorter than some length.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/sight/cone.h"
#include "lasius/grid/geometry.h"

namespace lasius::disc {

/// The box and the strip around the points p with |from p| + |p other| < sum, in cells, perhaps
/// infinite, for a scan whose line 0 is grid line `line0`: as exact::limits_around, for any points.
template <int S>
kernels::ConeLimits limits_around(const kernels::BitmapView& map, Point from, Point other,
                                  double sum, int down, int line0) noexcept {
  constexpr double kColumn = static_cast<double>(kernels::kOne);
  kernels::ConeLimits limits = kernels::whole_map<S>(map, down > 0 ? map.height - line0 : line0);
  if (std::isinf(sum)) return limits;
  const double u = S * from.x, v = down * (from.y - line0);
  const double du = 0.5 * S * (other.x - from.x);  // to the ellipse's middle
  const double dv = 0.5 * down * (other.y - from.y);
  const double axis = 0.5 * sum;  // half of the long one
  const double minor = std::max(0.0, axis * axis - du * du - dv * dv);
  constexpr double kSpare = 2;  // rounding, and the column that a scan may leave out
  const double right = u + du + std::sqrt(minor + du * du) + kSpare;
  const double depth = v + dv + std::sqrt(minor + dv * dv) + kSpare;
  if (right < limits.last_column) limits.last_column = static_cast<int>(std::floor(right)) + 1;
  if (depth < limits.last_line) limits.last_line = std::max(0, static_cast<int>(depth));
  // The strip along the long axis, where it fits the fixed point: its edges touch the ellipse at
  // the ends of the short axis.
  const double slope = du / dv;
  const double half = std::sqrt(minor * (1 + slope * slope)) + kSpare;
  if (std::abs(slope) * (limits.last_line + 1) + half < 0.5 * kernels::kAllColumns) {
    const double middle = u - slope * v;
    limits.slope = static_cast<kernels::Fixed>(slope * kColumn);
    limits.left0 = static_cast<kernels::Fixed>((middle - half) * kColumn);
    limits.right0 = static_cast<kernels::Fixed>((middle + half) * kColumn);
  }
  return limits;
}

}  // namespace lasius::disc
