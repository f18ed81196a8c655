#include "straighten.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "grid_view.h"
#include "lasius/path.h"

namespace lasius {
namespace {

double length_of(std::span<const Cell> polyline) noexcept {
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const double dx = polyline[i].x - polyline[i - 1].x;
    const double dy = polyline[i].y - polyline[i - 1].y;
    length += std::sqrt(dx * dx + dy * dy);
  }
  return length;
}

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
      if (by_column) {
        cells.push_back({a.x + step_x, a.y});
      } else if (!map.blocked(a.x, a.y + step_y)) {
        cells.push_back({a.x, a.y + step_y});
      }
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

void rasterise(const kernels::BitmapView& map, std::span<const Cell> polyline,
               std::vector<Cell>& cells) {
  cells.assign(1, polyline[0]);
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    append_segment(map, polyline[i - 1], polyline[i], cells);
  }
}

// Greedy line of sight: each piece ends at the last cell before the first hidden one. False when
// told to stop before the walk's end.
bool pull(const kernels::BitmapView& map, std::span<const Cell> walk, kernels::SightCone& cone,
          Poller& poller, std::vector<Cell>& polyline) {
  int lo = walk[0].x;
  int hi = lo;
  for (const Cell c : walk) {
    lo = std::min(lo, c.x);
    hi = std::max(hi, c.x);
  }
  polyline.assign(1, walk[0]);
  std::size_t next = 1;
  while (next < walk.size()) {
    const std::size_t anchor = next - 1;
    cone.start(map, walk[anchor].x, walk[anchor].y, lo, hi);
    while (next < walk.size() && cone.sees_next(walk[next].x, walk[next].y)) {
      ++next;
      if (poller.stop_after(cone.take_work())) return false;
    }
    if (next == anchor + 1) ++next;  // the walk squeezes between two diagonal blocks: so be it
    if (walk[next - 1] != polyline.back()) polyline.push_back(walk[next - 1]);
  }
  return true;
}

}  // namespace

void Straightener::run(const Grid& grid, std::span<const Cell> walk, const StopCondition& stop) {
  const kernels::BitmapView map = view_of(grid);
  Poller poller(stop);
  best_.assign(walk.begin(), walk.end());
  raster_.assign(walk.begin(), walk.end());
  length_ = length_of(best_);
  // The first pass only cuts short, whatever rounding says; later gains must beat rounding.
  constexpr double kShorter = 1 - 1e-12;
  bool forth = true;
  for (int pass = 0, in_vain = 0; in_vain < 2; ++pass, forth = !forth) {
    if (pass > 0) rasterise(map, best_, raster_);
    if (!forth) std::reverse(raster_.begin(), raster_.end());
    if (!pull(map, raster_, cone_, poller, pulled_)) break;
    if (!forth) std::reverse(pulled_.begin(), pulled_.end());
    const double length = length_of(pulled_);
    if (pass == 0 || length < length_ * kShorter) {
      length_ = length;
      best_.assign(pulled_.begin(), pulled_.end());
      in_vain = 0;
    } else {
      ++in_vain;
    }
  }
  rasterise(map, best_, raster_);
}

std::vector<Cell> straighten(const Grid& grid, std::span<const Cell> cells,
                             const StopCondition& stop) {
  if (cells.empty()) return {};
  Straightener straightener;
  straightener.run(grid, cells, stop);
  const auto vertices = straightener.vertices();
  return {vertices.begin(), vertices.end()};
}

}  // namespace lasius
