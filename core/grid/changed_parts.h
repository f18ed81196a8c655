// Cells of a map that change, as few rectangles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// The least rectangle that holds both.
inline Rectangle round_both(const Rectangle& a, const Rectangle& b) noexcept {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
          std::max(a.y + a.height, b.y + b.height) - top};
}

/// A rectangle, which may lie anywhere, and so many cells on each side, as far as these lie on the
/// map.
Rectangle widened(const Rectangle& part, int margin, const Grid& map) noexcept;

/// Rectangles around cells of a map in the order given, each one's up to before `end`.
struct ChangedParts {
  struct Part {
    Rectangle cells;
    std::size_t end;
  };
  std::vector<Part> parts;
  bool most;  ///< widened, they have more than half as many cells as the map
};

/// Cells named one after the other share a rectangle where that, widened by the margin, has fewer
/// cells than two would have.
ChangedParts parts_of(std::span<const Cell> changed, int margin, const Grid& map);

}  // namespace lasius
