#include "core/drive/doubts.h"

#include <algorithm>

#include "core/drive/sensor.h"
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
  const auto end = [](int from, int size, int most) {
    return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{from} + size, 0, most));
  };
  const int left = std::clamp(part.x, 0, map.width()), top = std::clamp(part.y, 0, map.height());
  seen_->fill({left, top, end(part.x, part.width, map.width()) - left,
               end(part.y, part.height, map.height()) - top},
              true);
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
