// Cells of a map by their distance from one.
#pragma once

#include <algorithm>

#include "core/base/poller.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Calls look(cell) for the cells around one of the map, ring by ring, as long as a ring has one
/// that comes as near to its points as `nearest`, which `look` may lower, and until stopped.
template <class Look>
void for_rings(const Grid& map, Cell at, const double& nearest, Poller& poller, const Look& look) {
  const int rings = std::max(map.width(), map.height());
  for (int ring = 0; ring < rings && ring - 1 <= nearest; ++ring) {
    const int top = std::max(0, at.y - ring), bottom = std::min(map.height() - 1, at.y + ring);
    for (int y = top; y <= bottom; ++y) {
      const bool edge = y == at.y - ring || y == at.y + ring;
      const int step = edge || ring == 0 ? 1 : 2 * ring;
      for (int x = at.x - ring; x <= at.x + ring; x += step)
        if (map.contains({x, y})) look(Cell{x, y});
      if (poller.stop_after(edge ? ring : 1)) return;
    }
  }
}

}  // namespace lasius
