#include "core/smooth/straighten.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/base/invalid_parameter.h"
#include "core/grid/cell_distance.h"
#include "core/grid/grid_view.h"
#include "lasius/path/smooth.h"

namespace lasius {
namespace {

// Gains must beat rounding.
constexpr double kShorter = 1 - 1e-12;

// Whether cells, seen one after another from a first one, stay within `window` of the line from it
// to the next: the directions in which a ray passes all of them so closely (the sleeve of Zhao &
// Saalfeld, Auto-Carto 13, 1997), and that none lies farther beyond the next than that.
class Sleeve {
 public:
  Sleeve(Cell from, double window) : from_(from), window_(window) {}

  // False for a cell whose segment leaves one before farther aside; otherwise it counts as one.
  bool takes_next(Cell c) noexcept {
    const double dx = c.x - from_.x, dy = c.y - from_.y;
    const double square = dx * dx + dy * dy;
    if (farthest_ > window_) {
      const double least = farthest_ - window_;
      if (square < least * least || right_x_ * dy - right_y_ * dx < 0 ||
          dx * left_y_ - dy * left_x_ < 0)
        return false;
    }
    if (!(square > window_ * window_)) return true;
    // Tangents from the first cell to the circle of that radius around this one.
    const double along = std::sqrt(square - window_ * window_);
    const double rx = dx * along + dy * window_, ry = dy * along - dx * window_;
    const double lx = dx * along - dy * window_, ly = dy * along + dx * window_;
    const bool first = !(farthest_ > window_);
    if (first || right_x_ * ry - right_y_ * rx > 0) right_x_ = rx, right_y_ = ry;
    if (first || lx * left_y_ - ly * left_x_ > 0) left_x_ = lx, left_y_ = ly;
    farthest_ = std::max(farthest_, std::sqrt(square));
    return true;
  }

 private:
  Cell from_;
  double window_;
  double farthest_ = 0;  // directions are bounded once a cell lay beyond the window
  double right_x_ = 0, right_y_ = 0, left_x_ = 0, left_y_ = 0;
};

// The last cell of a walk that a disc sees from the one at `anchor`, sought by steps of doubled,
// then of halved length, no farther than before the first whose segment would stray from the walk.
std::size_t last_seen(const CellSight& sight, std::span<const Cell> walk, std::size_t anchor,
                      double window, Poller& poller) {
  Sleeve sleeve(walk[anchor], window);
  std::size_t taken = anchor + 1;  // cells, none of which strays
  std::size_t last = anchor;
  const auto go_on = [&](std::size_t step) {
    const std::size_t to = last + step;
    if (to >= walk.size()) return false;
    while (taken <= to && (window == kInfinity || sleeve.takes_next(walk[taken]))) ++taken;
    poller.stop_after(std::abs(walk[to].y - walk[anchor].y) / 8 + 16);
    if (taken <= to || !sight(walk[anchor], walk[to])) return false;
    last = to;
    return true;
  };
  std::size_t step = 1;
  while (go_on(step)) step *= 2;
  while ((step /= 2) > 0) go_on(step);
  return last;
}

// Greedy line of sight: each piece ends at the last cell before the first hidden one, or before the
// first whose segment would stray from the walk. False when told to stop before the walk's end.
bool pull(const CellSight& sight, std::span<const Cell> walk, double window,
          kernels::SightCone& cone, Poller& poller, std::vector<Cell>& polyline) {
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
    if (sight.disc != nullptr) {
      next = last_seen(sight, walk, anchor, window, poller) + 1;
      if (poller.stopped()) return false;
    } else {
      cone.start(sight.map, walk[anchor].x, walk[anchor].y, lo, hi);
      Sleeve sleeve(walk[anchor], window);
      while (next < walk.size() && (window == kInfinity || sleeve.takes_next(walk[next])) &&
             cone.sees_next(walk[next].x, walk[next].y)) {
        ++next;
        if (poller.stop_after(cone.take_work())) return false;
      }
    }
    if (next == anchor + 1) ++next;  // the walk squeezes between two diagonal blocks: so be it
    if (walk[next - 1] != polyline.back()) polyline.push_back(walk[next - 1]);
  }
  return true;
}

bool sees(const kernels::BitmapView& map, Cell a, Cell b) noexcept {
  return kernels::sees_cell(map, a.x, a.y, b.x, b.y);
}

// Leaves out vertices and moves them to neighbouring cells as long as that makes the polyline
// shorter. False when told to stop.
bool settle(const CellSight& sight, Poller& poller, std::vector<Cell>& polyline) {
  for (bool changed = true; changed && polyline.size() > 2;) {
    changed = false;
    std::size_t kept = 1, i = 1;  // vertices between the two are left out
    const auto close_up = [&] {
      polyline.erase(polyline.begin() + static_cast<std::ptrdiff_t>(kept),
                     polyline.begin() + static_cast<std::ptrdiff_t>(i));
    };
    for (; i + 1 < polyline.size(); ++i) {
      const Cell a = polyline[kept - 1], b = polyline[i], c = polyline[i + 1];
      if (poller.stop_after(4 * std::abs(c.y - a.y) + 256)) {
        close_up();
        return false;
      }
      if (a == b || b == c || sight(a, c)) {
        changed = true;
        continue;
      }
      Cell best = b;
      double least = (distance(a, b) + distance(b, c)) * kShorter;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell to{b.x + dx, b.y + dy};
          const double length = distance(a, to) + distance(to, c);
          if (length >= least || sight.map.blocked(to.x, to.y)) continue;
          if (!sight(a, to) || !sight(to, c)) continue;
          least = length;
          best = to;
          changed = true;
        }
      }
      polyline[kept++] = best;
    }
    close_up();
  }
  return true;
}

/// @throws Error(invalid_parameter) unless the cells are a walk.
void check_walk(const Grid& grid, std::span<const Cell> cells) {
  const auto refuse = [](std::size_t i, const char* why) {
    throw invalid_parameter(
        "cell " + std::to_string(i) + " of the walk " + why,
        "give free cells, each one king's move from the one before or equal to it");
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (grid.blocked(cells[i])) refuse(i, "is blocked or outside");
    if (i == 0) continue;
    const std::int64_t dx = std::int64_t{cells[i].x} - cells[i - 1].x;
    const std::int64_t dy = std::int64_t{cells[i].y} - cells[i - 1].y;
    if (std::max(std::abs(dx), std::abs(dy)) > 1) refuse(i, "is not next to the one before");
  }
}

}  // namespace

/// Puts a taut string back on cells: the shortest polyline over two of the free cells around each
/// of its corners, into `pulled_`. False when there is none.
bool Straightener::string_on_cells(const Grid& grid, std::span<const Point> string,
                                   Poller& poller) {
  const kernels::BitmapView map = view_of(grid);
  if (string.size() < 2) return false;
  layers_.assign(1, {.cell = {best_.front()}, .count = 1});
  for (const Point corner : string.subspan(1, string.size() - 2)) {
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    Layer around;
    for (int dy = -kReach; dy < kReach; ++dy) {
      for (int dx = -kReach; dx < kReach; ++dx) {
        const Cell c{x + dx, y + dy};
        if (grid.contains(c) && grid.free(c)) around.cell[around.count++] = c;
      }
    }
    layers_.insert(layers_.end(), 2, around);
  }
  layers_.push_back({.cell = {best_.back()}, .count = 1});
  for (std::size_t i = 1; i < layers_.size(); ++i)
    if (!connect(map, poller, layers_[i - 1], layers_[i])) return false;
  pulled_.clear();
  for (std::size_t i = layers_.size(), k = 0; i-- > 0; k = layers_[i].from[k]) {
    const Cell c = layers_[i].cell[k];
    if (pulled_.empty() || pulled_.back() != c) pulled_.push_back(c);
  }
  std::ranges::reverse(pulled_);
  return true;
}

/// The shortest way to every cell of a layer over those of the one before; cells without one are
/// dropped. False when none is left.
bool Straightener::connect(const kernels::BitmapView& map, Poller& poller, const Layer& before,
                           Layer& layer) {
  int reached = 0;
  for (int k = 0; k < layer.count; ++k) {
    const Cell to = layer.cell[k];
    std::array<double, kCells> length;
    for (int j = 0; j < before.count; ++j)
      length[j] = before.length[j] + distance(before.cell[j], to);
    for (int left = before.count; left > 0; --left) {
      const auto least = std::min_element(length.begin(), length.begin() + before.count);
      if (*least == kInfinity) break;
      const auto j = static_cast<int>(least - length.begin());
      if (poller.stop_after(std::abs(to.y - before.cell[j].y) + 16)) return false;
      if (sees(map, before.cell[j], to)) {
        layer.cell[reached] = to;
        layer.length[reached] = *least;
        layer.from[reached++] = j;
        break;
      }
      *least = kInfinity;
    }
  }
  layer.count = reached;
  return reached > 0;
}

/// Greedy passes from either end until neither shortens the polyline. False when told to stop.
bool Straightener::pull_from_both_ends(const CellSight& sight, Poller& poller) {
  bool forth = false;
  for (int in_vain = 0; in_vain < 2; forth = !forth) {
    rasterise(sight, best_, raster_);
    if (!forth) std::ranges::reverse(raster_);
    if (!pull(sight, raster_, window_, cone_, poller, pulled_)) return false;
    if (!forth) std::ranges::reverse(pulled_);
    in_vain = keep_if_shorter() ? 0 : in_vain + 1;
  }
  return true;
}

bool Straightener::keep_if_shorter() {
  const double length = length_of(pulled_);
  if (!(length < length_ * kShorter)) return false;
  length_ = length;
  best_.assign(pulled_.begin(), pulled_.end());
  return true;
}

void Straightener::run(const Grid& grid, std::span<const Cell> walk, const StopCondition& stop,
                       double window) {
  window_ = window;
  Poller poller(stop);
  best_.assign(walk.begin(), walk.end());
  pull_all({view_of(grid)}, poller);
}

/// From a walk to a polyline and the cells under it.
void Straightener::pull_all(const CellSight& sight, Poller& poller) {
  // The first pass only cuts short, whatever rounding says.
  if (pull(sight, best_, window_, cone_, poller, pulled_))
    best_.assign(pulled_.begin(), pulled_.end());
  length_ = length_of(best_);
  if (!poller.stopped()) pull_from_both_ends(sight, poller);
  rasterise(sight, best_, raster_);
}

void Straightener::keep_radius(const Grid& grid, const disc::DiscSpace& disc, bool settled,
                               const StopCondition& stop) {
  const CellSight sight{view_of(grid), &disc};
  Poller poller(stop);
  point_raster_.assign(raster_.begin(), raster_.end());
  best_.assign(raster_.begin(), raster_.end());
  pull_all(sight, poller);
  while (settled) {
    pulled_.assign(best_.begin(), best_.end());
    settled =
        settle(sight, poller, pulled_) && keep_if_shorter() && pull_from_both_ends(sight, poller);
  }
  raster_.swap(point_raster_);
}

void Straightener::straighten(const Grid& grid, const StopCondition& stop) {
  if (best_.size() < 3 || stop.poll() != StopCondition::Cause::none) return;
  const kernels::BitmapView map = view_of(grid);
  const CellSight sight{map};
  for (std::size_t i = 1; i < best_.size(); ++i) {
    if (sees(map, best_[i - 1], best_[i])) continue;
    taut_string_.run(grid, best_, Corners::allow, stop);  // a squeeze that is kept
    return;
  }
  Poller poller(stop);
  const auto settle_and_keep = [&] { return settle(sight, poller, pulled_) && keep_if_shorter(); };
  // A vertex less, or pieces pulled again, may pass an obstacle on its other side: another string.
  for (bool shorter = true; shorter;) {
    taut_string_.run(grid, best_, Corners::forbid, stop);
    shorter = string_on_cells(grid, taut_string_.path(), poller) && settle_and_keep();
    if (!shorter) {
      pulled_.assign(best_.begin(), best_.end());
      shorter = settle_and_keep();
    }
    shorter = shorter && pull_from_both_ends(sight, poller);
  }
  rasterise(sight, best_, raster_);
}

void Straightener::take(const Grid& grid, std::span<const Point> string,
                        const StopCondition& stop) {
  Poller poller(stop);
  if (!string_on_cells(grid, string, poller) || !keep_if_shorter()) return;
  rasterise({view_of(grid)}, best_, raster_);
  straighten(grid, stop);
}

std::vector<Cell> greedy_straighten(const Grid& grid, std::span<const Cell> cells,
                                    const StopCondition& stop) {
  check_walk(grid, cells);
  if (cells.empty()) return {};
  Straightener straightener;
  straightener.run(grid, cells, stop);
  return {straightener.vertices().begin(), straightener.vertices().end()};
}

std::vector<Cell> straighten(const Grid& grid, std::span<const Cell> cells,
                             const StopCondition& stop) {
  check_walk(grid, cells);
  if (cells.empty()) return {};
  Straightener straightener;
  straightener.run(grid, cells, stop);
  straightener.straighten(grid, stop);
  return {straightener.vertices().begin(), straightener.vertices().end()};
}

}  // namespace lasius
