// A set of cells whose size follows the cells, not the map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// Cells of a grid in tiles of 8 x 8, found through a small hash table. Keeps its memory when it is
/// emptied.
class CellSet {
 public:
  static constexpr std::int32_t kNone = -1;

  struct Tile {
    std::uint64_t cells;  ///< cell (x, y) is bit 8 (y % 8) + x % 8
    std::uint32_t key;    ///< column | row << 16

    Cell cell(int bit) const noexcept {
      return {static_cast<int>(key & 0xffff) * 8 + (bit & 7),
              static_cast<int>(key >> 16) * 8 + (bit >> 3)};
    }
  };

  static constexpr std::uint32_t key_of(Cell c) noexcept {
    return static_cast<std::uint32_t>(c.x >> 3) | static_cast<std::uint32_t>(c.y >> 3) << 16;
  }
  static constexpr int bit_of(Cell c) noexcept { return (c.y & 7) * 8 + (c.x & 7); }

  /// Forgets all; room for the cells of walks with `cells` cells in all.
  void reset(std::size_t cells);

  /// A cell of a grid.
  void add(Cell c) {
    if (key_of(c) != last_key_) {
      last_key_ = key_of(c);
      last_ = tile_of(last_key_);
    }
    tiles_[last_].cells |= std::uint64_t{1} << bit_of(c);
  }

  /// Any cell, of the grid or beside it.
  bool has(Cell c) const noexcept {
    const std::int32_t tile = find(key_of(c));
    return tile != kNone && (tiles_[tile].cells >> bit_of(c) & 1) != 0;
  }

  /// Is lattice point (x, y) a corner of one of the cells?
  bool touches(int x, int y) const noexcept {
    return has({x, y}) || has({x - 1, y}) || has({x, y - 1}) || has({x - 1, y - 1});
  }

  /// In the order in which they were first entered. The next cell added may move them.
  std::span<const Tile> tiles() const noexcept { return tiles_; }
  /// Index of the tile with this key, or kNone.
  std::int32_t find(std::uint32_t key) const noexcept { return slots_[slot_of(key)]; }

  std::int64_t bytes() const noexcept { return held_bytes(slots_, tiles_); }  ///< memory held

 private:
  static constexpr std::uint32_t kNoKey = ~std::uint32_t{0};  // no grid is so large

  std::size_t slot_of(std::uint32_t key) const noexcept;
  std::int32_t tile_of(std::uint32_t key);

  // Open addressing, a power of two, at least half of them free.
  std::vector<std::int32_t> slots_ = std::vector<std::int32_t>(2, kNone);
  std::vector<Tile> tiles_;
  std::uint32_t last_key_ = kNoKey;
  std::int32_t last_ = kNone;
};

}  // namespace lasius
