#include "lasius/path.h"

#include <cmath>

#include "core/grid/grid_view.h"
#include "kernels/sight/sight.h"

namespace lasius {

double path_length(std::span<const Point> path) noexcept {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double dx = path[i].x - path[i - 1].x;
    const double dy = path[i].y - path[i - 1].y;
    length += std::sqrt(dx * dx + dy * dy);
  }
  return length;
}

bool visible(const Grid& grid, Cell a, Cell b) noexcept {
  return grid.free(a) && grid.free(b) && kernels::sees_cell(view_of(grid), a.x, a.y, b.x, b.y);
}

}  // namespace lasius
