#include "core/drive/edited_map.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/held_bytes.h"
#include "core/disc/disc_cells.h"
#include "core/grid/changed_parts.h"
#include "core/grid/grid_view.h"

namespace lasius {
namespace {

auto part_of(Cell c) noexcept { return std::pair(c.y >> 6, c.x >> 6); }

Rectangle round(std::span<const Cell> cells) noexcept {
  Rectangle all{cells[0].x, cells[0].y, 1, 1};
  for (const Cell c : cells) all = round_both(all, {c.x, c.y, 1, 1});
  return all;
}

}  // namespace

EditedMap::EditedMap(Grid map, double radius)
    : map_(std::move(map)), growth_(disc::growth(map_, radius)) {
  if (radius > 0) grown_ = grow_obstacles(map_, growth_, {});
}

void EditedMap::set(std::span<const Cell> cells, bool blocked, const OnChange& changed,
                    const OnChange& edited) {
  differing_.clear();
  for (const Cell c : cells)
    if (map_.contains(c) && map_.blocked(c) != blocked) differing_.push_back(c);
  apply(blocked, changed, edited);
}

void EditedMap::set(const Rectangle& part, bool blocked, const OnChange& changed,
                    const OnChange& edited) {
  if (part.width <= 0 || part.height <= 0) return;
  differing_.clear();
  const Rectangle inside = widened(part, 0, map_);
  const int right = inside.x + inside.width, bottom = inside.y + inside.height;
  // Part by part, so that a large rectangle takes no more memory than a row of parts.
  for (int y = inside.y; y < bottom; ++y) {
    for (int x = inside.x; x < right; ++x)
      if (map_.blocked({x, y}) != blocked) differing_.push_back({x, y});
    if ((y & 63) == 63 || y + 1 == bottom) {
      apply(blocked, changed, edited);
      differing_.clear();
    }
  }
}

void EditedMap::apply(bool blocked, const OnChange& changed, const OnChange& edited) {
  std::ranges::sort(differing_, [](Cell a, Cell b) {
    return std::tuple(part_of(a), a.y, a.x) < std::tuple(part_of(b), b.y, b.x);
  });
  differing_.erase(std::unique(differing_.begin(), differing_.end()), differing_.end());
  for (auto begin = differing_.begin(); begin != differing_.end();) {
    const auto end = std::find_if(begin, differing_.end(),
                                  [&](Cell c) { return part_of(c) != part_of(*begin); });
    const std::span<const Cell> cells(&*begin, static_cast<std::size_t>(end - begin));
    for (const Cell c : cells) map_.set_blocked(c, blocked);
    if (edited) edited(round(cells), cells);
    if (grown_)
      grow(round(cells), blocked, changed);
    else
      changed(round(cells), cells);
    begin = end;
  }
}

void EditedMap::grow(const Rectangle& part, bool blocked, const OnChange& changed) {
  const Rectangle around = widened(part, growth_.reach(), map_);
  grown_cells_.clear();
  for (int y = around.y; y < around.y + around.height; ++y) {
    for (int x = around.x; x < around.x + around.width; ++x) {
      const Cell cell{x, y};
      if (grown_->blocked(cell) == blocked || growth_.blocked(map_, cell) != blocked) continue;
      grown_->set_blocked(cell, blocked);
      grown_cells_.push_back(cell);
    }
  }
  if (!grown_cells_.empty()) changed(round(grown_cells_), grown_cells_);
}

std::int64_t EditedMap::bytes() const noexcept {
  return bitmap_bytes(map_) + (grown_ ? bitmap_bytes(*grown_) : 0) +
         held_bytes(differing_, grown_cells_);
}

}  // namespace lasius
