// Circles about corners of blocked cells, and the pieces that a disc's centre may be on.
#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>

#include "core/grid/distance.h"
#include "kernels/base/arctangent.h"
#include "lasius/grid/geometry.h"

namespace lasius::disc {

/// All tests of a distance allow for so much, in cells: a disc fits where its centre is nowhere
/// nearer to a blocked cell than its radius less this. With the margin below and rounding, paths
/// keep what was asked for to 1e-9.
constexpr double kSlack = 0.8e-9;
/// What boxes and arcs are made with, so that their ends pass such tests.
constexpr double kMadeSlack = 0.7e-9;

/// What a radius is planned with less than was asked for, in cells. A disc that touches two corners
/// at once then passes between them with room to compute in: without, the line that touches both
/// circles where they meet has no length and, by rounding, no direction.
constexpr double kRadiusMargin = 1e-10;

/// A unit vector in the quadrant of both signs: the sizes of its components.
struct Normal {
  double a = 1, b = 0;

  double angle() const noexcept { return kernels::quadrant_angle(a, b); }  ///< from (1, 0)
};

/// The piece of a circle about a corner of a blocked cell that keeps the radius from all others.
///
/// A corner is a lattice point with exactly one of its four cells blocked. Normals of its circle
/// that point away from that cell lie in one quadrant: its type, whose bit 0 says that x is
/// negative, bit 1 that y is. How far a normal (a, b) has turned in its quadrant is told by its
/// fraction b / (a + b): 0 along x, 1 along y.
struct Arc {
  std::uint16_t x = 0, y = 0;  ///< of the corner
  std::uint32_t type = 0;      ///< 0 to 3
  double low = 0, high = 1;    ///< fractions at the ends

  friend bool operator==(const Arc&, const Arc&) = default;

  int right() const noexcept { return (type & 1) != 0 ? -1 : 1; }  ///< sign of normals' x
  int down() const noexcept { return (type & 2) != 0 ? -1 : 1; }   ///< sign of normals' y
};
static_assert(sizeof(Arc) == 24);

/// An order of the arcs of a space that does not depend on how they are numbered.
inline bool comes_before(const Arc& a, const Arc& b) noexcept {
  const auto place = [](const Arc& arc) {
    return std::tuple(arc.y >> 3, arc.x >> 3, arc.y, arc.x, arc.low);
  };
  return place(a) < place(b);
}

/// How far a normal has turned past an end of an arc: the angle's sine times a number of [0.7, 1].
inline double past(double fraction, Normal n) noexcept {
  return (1 - fraction) * n.b - fraction * n.a;
}

/// Is a normal of an arc's quadrant on the arc, up to rounding?
inline bool on_arc(const Arc& arc, Normal n) noexcept {
  return past(arc.low, n) >= -kSlack && past(arc.high, n) <= kSlack;
}

/// The normal with a fraction.
inline Normal normal_at(double fraction) noexcept {
  const double a = 1 - fraction;
  const double size = std::sqrt(a * a + fraction * fraction);
  return {a / size, fraction / size};
}

inline Point point_on(const Arc& arc, Normal n, double radius) noexcept {
  return {arc.x + arc.right() * (radius * n.a), arc.y + arc.down() * (radius * n.b)};
}

}  // namespace lasius::disc
