// How far apart cells are.
#pragma once

#include <cmath>

#include "lasius/geometry.h"

namespace lasius {

/// Straight, from centre to centre.
inline double distance(Cell a, Cell b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace lasius
