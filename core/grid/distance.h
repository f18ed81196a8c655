// How far two points are apart.
#pragma once

#include <cmath>

#include "lasius/grid/geometry.h"

namespace lasius {

inline double distance(Point a, Point b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace lasius
