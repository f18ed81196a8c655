#include "core/grid/cell_set.h"

#include <bit>

namespace lasius {

void CellSet::reset(std::size_t cells) {
  slots_.assign(std::bit_ceil(cells / 8 + 16), kNone);
  // Room now: to copy millions while it grows would take long between two polls.
  tiles_.clear();
  tiles_.reserve(slots_.size() / 2 + 1);
  last_key_ = kNoKey;
}

/// The slot that holds a tile of this key, or the free one where it belongs.
std::size_t CellSet::slot_of(std::uint32_t key) const noexcept {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = (key * std::uint64_t{0x9e3779b97f4a7c15}) >> 32 & mask;
  while (slots_[slot] != kNone && tiles_[slots_[slot]].key != key) slot = (slot + 1) & mask;
  return slot;
}

std::int32_t CellSet::tile_of(std::uint32_t key) {
  const std::int32_t known = find(key);
  if (known != kNone) return known;
  const auto made = static_cast<std::int32_t>(tiles_.size());
  tiles_.push_back({0, key});
  if (2 * tiles_.size() > slots_.size()) {
    slots_.assign(2 * slots_.size(), kNone);
    for (std::int32_t i = 0; i < made; ++i) slots_[slot_of(tiles_[i].key)] = i;
  }
  return slots_[slot_of(key)] = made;
}

}  // namespace lasius
