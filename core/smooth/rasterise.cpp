// The cells under a polyline.
#include <cstdlib>

#include "core/smooth/straighten.h"

namespace lasius {
namespace {

// Appends the cells that the segment a - b crosses, a left out. Through a lattice point the way
// goes by the free cell beside it, by columns first where both are free.
void append_segment(const kernels::BitmapView& map, Cell a, Cell b, std::vector<Cell>& cells) {
  const int step_x = b.x > a.x ? 1 : -1;
  const int step_y = b.y > a.y ? 1 : -1;
  const std::int64_t dx = std::abs(b.x - a.x);
  const std::int64_t dy = std::abs(b.y - a.y);
  // Sign: which comes first, the next line between rows (> 0) or between columns (< 0)?
  std::int64_t ahead = dy - dx;
  while (a != b) {
    if (ahead == 0) {
      const bool by_column = !map.blocked(a.x + step_x, a.y);
      if (by_column)
        cells.push_back({a.x + step_x, a.y});
      else if (!map.blocked(a.x, a.y + step_y))
        cells.push_back({a.x, a.y + step_y});
      a = {a.x + step_x, a.y + step_y};
      ahead += 2 * dy - 2 * dx;
    } else if (ahead < 0) {
      a.x += step_x;
      ahead += 2 * dy;
    } else {
      a.y += step_y;
      ahead -= 2 * dx;
    }
    cells.push_back(a);
  }
}

// Of the cells from number `first` on, a segment's, leaves those that a disc's centre can go over
// straight from one to the next.
void keep_walkable(const CellSight& sight, std::size_t first, std::vector<Cell>& cells) {
  const Cell end = cells.back();
  std::size_t kept = first;
  for (std::size_t i = first; i + 1 < cells.size(); ++i) {
    const Cell c = cells[i];
    if (!sight.map.blocked(c.x, c.y) && sight(cells[kept - 1], c)) cells[kept++] = c;
  }
  while (kept > first && !sight(cells[kept - 1], end)) --kept;
  cells.resize(kept);
  cells.push_back(end);
}

}  // namespace

void rasterise(const CellSight& sight, std::span<const Cell> polyline, std::vector<Cell>& cells) {
  cells.assign(1, polyline[0]);
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const std::size_t first = cells.size();
    append_segment(sight.map, polyline[i - 1], polyline[i], cells);
    if (sight.disc != nullptr && cells.size() > first) keep_walkable(sight, first, cells);
  }
}

}  // namespace lasius
