#include "core/drive/doubts.h"

#include "core/drive/sensor.h"
#include "core/grid/changed_parts.h"
#include "core/grid/grid_view.h"

namespace lasius {

void Doubts::learn(const Grid& map) {
  if (after_ > 0 && !given_) given_ = map;
}

void Doubts::saw_walls(const Grid& map, std::span<const Cell> cells) {
  learn(map);
  if (waited_ == 0) return;
  for (const Cell c : cells)
    if (seen_->contains(c)) seen_->set_blocked(c);
}

void Doubts::saw_walls(const Grid& map, const Rectangle& part) {
  learn(map);
  if (waited_ == 0 || part.width <= 0 || part.height <= 0) return;
  seen_->fill(widened(part, 0, map), true);
}

std::vector<Cell> Doubts::wait(const Grid& map) {
  if (!given_) return {};
  if (waited_ == 0) seen_.emplace(map.width(), map.height());
  if (++waited_ <= after_) return {};
  waited_ = 0;
  return walls_without(map, *seen_, &*given_);
}

std::int64_t Doubts::bytes() const noexcept {
  return (given_ ? bitmap_bytes(*given_) : 0) + (seen_ ? bitmap_bytes(*seen_) : 0);
}

}  // namespace lasius
