// How far a scan looks for paths that are shorter than some length.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/sight/scan_cone.h"
#include "kernels/sight/sight.h"

namespace lasius::exact {

/// The points p with |root p| + |p other| < sum; the foci in half cells, `sum` in cells, perhaps
/// infinite.
struct Ellipse {
  kernels::HalfPoint root, other;
  double sum;
};

/// The box and the strip around an ellipse, as limits of a scan from its root whose line 0 is grid
/// line `line0`.
template <int S>
kernels::ConeLimits limits_around(const kernels::BitmapView& map, const Ellipse& ellipse, int down,
                                  int line0) noexcept {
  constexpr double kOne = static_cast<double>(kernels::kOne);
  const kernels::HalfPoint root = ellipse.root;
  kernels::ConeLimits limits = kernels::whole_map<S>(map, down > 0 ? map.height - line0 : line0);
  if (std::isinf(ellipse.sum)) return limits;
  const double dx = 0.25 * (ellipse.other.x - root.x);  // from the root to the ellipse's middle
  const double dy = 0.25 * (ellipse.other.y - root.y);
  const double axis = 0.5 * ellipse.sum;  // half of the long one
  const double minor = std::max(0.0, axis * axis - dx * dx - dy * dy);
  const double right = S * (0.5 * root.x + dx) + std::sqrt(minor + dx * dx);
  const double depth = down * dy + std::sqrt(minor + dy * dy);
  constexpr int kSpare = 2;  // rounding, and the column that a scan may leave out
  limits.last_column =
      std::min(limits.last_column, static_cast<int>(std::floor(right)) + 1 + kSpare);
  limits.last_line = std::min(limits.last_line, static_cast<int>(depth) + kSpare);
  // The strip along the long axis, where it fits the fixed point: its edges touch the ellipse at
  // the ends of the short axis.
  const double slope = S * dx / (down * dy);
  const double half = std::sqrt(minor * (1 + slope * slope)) + kSpare;
  if (std::abs(slope) * (limits.last_line + 1) + half < 0.5 * kernels::kAllColumns) {
    const double middle = slope * 0.5 * (root.y & 1);
    const kernels::Fixed column = kernels::Fixed{S} * root.x * (kernels::kOne / 2);
    limits.slope = static_cast<kernels::Fixed>(slope * kOne);
    limits.left0 = column + static_cast<kernels::Fixed>((middle - half) * kOne);
    limits.right0 = column + static_cast<kernels::Fixed>((middle + half) * kOne);
  }
  return limits;
}

}  // namespace lasius::exact
