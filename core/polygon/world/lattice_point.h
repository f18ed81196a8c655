// Points on the grid of a prepared world, and predicates on them without rounding.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/grid/distance.h"
#include "lasius/grid/geometry.h"

namespace lasius::polygon {

/// Whole numbers below 2^45 in size, so that products of differences fit 128 bits with room.
struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

__extension__ using Wide = __int128;

inline LatticePoint operator-(LatticePoint a, LatticePoint b) noexcept {
  return {a.x - b.x, a.y - b.y};
}

inline Wide cross(LatticePoint a, LatticePoint b) noexcept {
  return static_cast<Wide>(a.x) * b.y - static_cast<Wide>(a.y) * b.x;
}
inline Wide dot(LatticePoint a, LatticePoint b) noexcept {
  return static_cast<Wide>(a.x) * b.x + static_cast<Wide>(a.y) * b.y;
}

/// Above 0: c lies left of the way from a to b; 0: on its line.
inline Wide side(LatticePoint a, LatticePoint b, LatticePoint c) noexcept {
  return cross(b - a, c - a);
}

inline bool between(std::int64_t a, std::int64_t b, std::int64_t c) noexcept {
  return a <= b ? a <= c && c <= b : b <= c && c <= a;
}

/// Whether c lies on the closed segment ab.
inline bool on_segment(LatticePoint a, LatticePoint b, LatticePoint c) noexcept {
  return between(a.x, b.x, c.x) && between(a.y, b.y, c.y) && side(a, b, c) == 0;
}

inline int sign(Wide value) noexcept { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Whether two closed segments share a point.
inline bool segments_meet(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) noexcept {
  const int abc = sign(side(a, b, c)), abd = sign(side(a, b, d));
  if (abc * abd > 0) return false;
  const int cda = sign(side(c, d, a)), cdb = sign(side(c, d, b));
  if (cda * cdb > 0) return false;
  if (abc != 0 || abd != 0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a);
}

inline bool same_direction(LatticePoint a, LatticePoint b) noexcept {
  return cross(a, b) == 0 && dot(a, b) > 0;
}

/// Whether the turn from direction a to direction b, counter-clockwise, is at most 180 degrees.
/// Equal directions are a full turn.
inline bool convex_turn(LatticePoint a, LatticePoint b) noexcept {
  const Wide c = cross(a, b);
  return c > 0 || (c == 0 && dot(a, b) < 0);
}

/// Whether, turning counter-clockwise from direction `base`, b is met strictly after a. Directions
/// equal to `base` are met at once.
inline bool turns_after(LatticePoint base, LatticePoint a, LatticePoint b) noexcept {
  const auto half = [base](LatticePoint d) {
    const Wide c = cross(base, d);
    if (c == 0) return dot(base, d) > 0 ? 0 : 2;
    return c > 0 ? 1 : 3;
  };
  const int ha = half(a), hb = half(b);
  return ha != hb ? ha < hb : cross(a, b) > 0;
}

/// From coordinates of a world to the grid and back. The spacing is a power of two, so that round
/// numbers stay as they are.
struct Lattice {
  double origin_x = 0;
  double origin_y = 0;
  double spacing = 1;

  /// In grid units, not rounded.
  Point scaled(Point p) const noexcept {
    return {(p.x - origin_x) / spacing, (p.y - origin_y) / spacing};
  }
  LatticePoint nearest(Point p) const noexcept {
    const Point s = scaled(p);
    return {std::llrint(s.x), std::llrint(s.y)};
  }
  Point point(LatticePoint p) const noexcept {
    return {origin_x + static_cast<double>(p.x) * spacing,
            origin_y + static_cast<double>(p.y) * spacing};
  }
};

}  // namespace lasius::polygon
