#include <algorithm>
#include <cmath>

#include "lasius/grid/clearance.h"

namespace lasius {

NearestBlocked nearest_blocked(const Grid& grid, Point at, double most, double beside) {
  const Cell middle{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
  NearestBlocked best{most, {}};
  const auto look = [&](int x, int y) {
    if (grid.free({x, y})) return;
    const double dx = std::max({x - at.x - beside, at.x - x - 1 - beside, 0.0});
    const double dy = std::max({y - at.y - beside, at.y - y - 1 - beside, 0.0});
    if (const double d = std::sqrt(dx * dx + dy * dy); d < best.distance) best = {d, {x, y}};
  };
  // Ring by ring: cells of ring r are at least r - 1 away.
  for (int r = 0; r - 1 - beside < best.distance; ++r)
    for (int i = -r; i <= r; ++i) {
      look(middle.x + i, middle.y - r);
      look(middle.x + i, middle.y + r);
      look(middle.x - r, middle.y + i);
      look(middle.x + r, middle.y + i);
    }
  return best;
}

}  // namespace lasius
