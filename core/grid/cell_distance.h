// How far apart cells are.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "lasius/geometry.h"

namespace lasius {

/// Straight, from centre to centre.
inline double distance(Cell a, Cell b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Of the polyline through these centres.
inline double length_of(std::span<const Cell> polyline) noexcept {
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    length += distance(polyline[i - 1], polyline[i]);
  return length;
}

}  // namespace lasius
