// Straight lines that touch two circles of the same radius, or points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/disc/arc.h"

namespace lasius::disc {

/// The quadrant that a view's rays run into, as u, v >= 0: u = right * x, v = down * y.
struct Heading {
  int right = 1, down = 1;
};

/// Rays into a quadrant turn around circles on their left (towards v) or right (towards u). A ray
/// of direction (b, a) in u, v, with a, b >= 0, touches a circle at its centre + offset (a, -b),
/// where the offset is the radius for a circle on its left and minus the radius for one on its
/// right; 0 for a point. Along an arc the normal's fraction falls for a circle on the left, rises
/// for one on the right.
constexpr Heading heading_of(const Arc& arc, bool rising) noexcept {
  const int right = (arc.type & 1) != 0 ? -1 : 1, down = (arc.type & 2) != 0 ? -1 : 1;
  return rising ? Heading{-right, down} : Heading{right, -down};
}
/// The type of the arcs that rays of a heading pass on their right, or left.
constexpr std::uint32_t type_passed(Heading heading, bool rising) noexcept {
  const bool left = (heading.right > 0) == rising, up = (heading.down > 0) != rising;
  return (left ? 1u : 0u) | (up ? 2u : 0u);
}

/// A line that touches one circle, then another.
struct Tangent {
  Normal normal;
  double length;  ///< between the points where it touches; negative: there is none
};

/// From a circle to one whose centre lies at (u, v) from its own; `offsets`: that of the first one
/// less that of the second. Both components of the normal may be negative: then the line leads into
/// another quadrant.
inline Tangent tangent(double u, double v, double offsets) noexcept {
  const double square = u * u + v * v;
  const double rest = square - offsets * offsets;
  // Circles that touch, but for the slack, have a tangent.
  if (!(rest >= -8 * kSlack * std::abs(offsets)) || square == 0) return {{}, -1};
  const double length = std::sqrt(std::max(0.0, rest));
  return {{(offsets * u + length * v) / square, (length * u - offsets * v) / square}, length};
}

}  // namespace lasius::disc
