// Where cells are, and how far apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "lasius/grid/geometry.h"

namespace lasius {

/// The cell that a point lies in, on a border that right of it or below.
inline Cell cell_at(Point p) noexcept { return {static_cast<int>(p.x), static_cast<int>(p.y)}; }

/// Straight, from centre to centre.
inline double distance(Cell a, Cell b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// From a cell's centre to that of the nearest cell of a rectangle that is not empty.
inline double distance(Cell c, const Rectangle& part) noexcept {
  return distance(c, Cell{std::clamp(c.x, part.x, part.x + part.width - 1),
                          std::clamp(c.y, part.y, part.y + part.height - 1)});
}

/// Of the polyline through these centres.
inline double length_of(std::span<const Cell> polyline) noexcept {
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    length += distance(polyline[i - 1], polyline[i]);
  return length;
}

}  // namespace lasius
