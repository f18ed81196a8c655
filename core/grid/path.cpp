#include "lasius/path/path.h"

#include "core/grid/distance.h"
#include "core/grid/grid_view.h"
#include "kernels/sight/sight.h"

namespace lasius {

double path_length(std::span<const Point> path) noexcept {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
  return length;
}

bool visible(const Grid& grid, Cell a, Cell b) noexcept {
  return grid.free(a) && grid.free(b) && kernels::sees_cell(view_of(grid), a.x, a.y, b.x, b.y);
}

}  // namespace lasius
