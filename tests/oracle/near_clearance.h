// The least distance from a segment to what is blocked, by every square near it.
#pragma once

#include <algorithm>
#include <cmath>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::oracle {

/// From a segment on the map to the nearest blocked square or the outside, at most `most` cells.
/// Looks at all squares around each piece of at most a cell.
inline double near_clearance(const Grid& grid, Point a, Point b, double most) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const auto to = [&](double px, double py) {
    const double along = square > 0 ? ((px - a.x) * x + (py - a.y) * y) / square : 0;
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(a.x + t * x - px, a.y + t * y - py);
  };
  double least = most;
  const int pieces = 1 + static_cast<int>(std::sqrt(square));
  const int reach = static_cast<int>(most) + 2;
  for (int piece = 0; piece <= pieces; ++piece) {
    const double share = static_cast<double>(piece) / pieces;
    const double px = a.x + share * x, py = a.y + share * y;
    const int column = static_cast<int>(std::floor(px)), row = static_cast<int>(std::floor(py));
    for (int j = row - reach; j <= row + reach; ++j) {
      for (int i = column - reach; i <= column + reach; ++i) {
        if (grid.free({i, j})) continue;
        // Outside a square an end of a segment is nearest to it, or a corner of it to the segment.
        const auto from = [&](Point p) {
          return std::hypot(p.x - std::clamp<double>(p.x, i, i + 1),
                            p.y - std::clamp<double>(p.y, j, j + 1));
        };
        least = std::min({least, from({px, py}), from(a), from(b), to(i, j), to(i + 1, j),
                          to(i, j + 1), to(i + 1, j + 1)});
      }
    }
  }
  return least;
}

}  // namespace lasius::oracle
