// The corners that a search has reached, and the one table that finds them.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace lasius::exact {

/// The cone a path may go on in after it turned at a corner: a quadrant given by two signs, and the
/// side of it that the turn is towards.
class Heading {
 public:
  Heading() = default;
  /// Signs of dx and dy; turned towards the vertical line (else towards the horizontal one)?
  constexpr Heading(int right, int down, bool towards_column) noexcept
      : bits_(static_cast<std::uint8_t>((right > 0 ? 1 : 0) | (down > 0 ? 2 : 0) |
                                        (towards_column ? 4 : 0))) {}
  constexpr int right() const noexcept { return (bits_ & 1) * 2 - 1; }
  constexpr int down() const noexcept { return (bits_ & 2) - 1; }
  constexpr bool towards_column() const noexcept { return (bits_ & 4) != 0; }

 private:
  std::uint8_t bits_ = 0;
};

/// A corner of a blocked cell, or the start (index 0), in half-cell coordinates.
struct Corner {
  int x = 0, y = 0;
  double length = 0;   ///< of the shortest known path from the start
  double to_goal = 0;  ///< straight distance
  std::uint32_t parent = 0;
  Heading heading = {};
  bool expanded = false;   ///< its cone was scanned at this length
  bool weighed = false;    ///< the weighted search has expanded it
  std::uint8_t scans = 0;  ///< how often its cone was scanned and cut off, at this length
};
static_assert(sizeof(Corner) == 32);

/// All corners reached, by index and by place. Place and index share a word of an open table with
/// linear probing that is at most half full.
class CornerTable {
 public:
  static constexpr std::uint32_t kStart = 0;

  /// Forgets all; `width` of the map in cells.
  void reset(int width, const Corner& start) {
    tiles_ = (static_cast<std::uint32_t>(width) >> 3) + 1;
    corners_.clear();
    corners_.push_back(start);
    rehash(kSmallest);
  }

  Corner& operator[](std::uint32_t i) noexcept { return corners_[i]; }
  const Corner& operator[](std::uint32_t i) const noexcept { return corners_[i]; }
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(corners_.size()); }

  /// Where lattice point (x, y) is in the table, or would be.
  std::size_t slot(int x, int y) const noexcept {
    const std::uint64_t place = place_of(x, y);
    std::size_t at = home(place);
    while (table_[at] != 0 && table_[at] >> 32 != place) at = (at + 1) & (table_.size() - 1);
    return at;
  }
  /// The index at a slot, kStart if it is empty.
  std::uint32_t at(std::size_t slot) const noexcept {
    return static_cast<std::uint32_t>(table_[slot]);
  }
  /// Makes a corner at lattice point (x, y) for the empty slot found for it; its caller fills in
  /// the rest. Invalidates slots.
  std::uint32_t add(std::size_t slot, int x, int y) {
    const std::uint32_t index = size();
    Corner& corner = corners_.emplace_back();
    corner.x = 2 * x;
    corner.y = 2 * y;
    table_[slot] = place_of(x, y) << 32 | index;
    if (corners_.size() * 2 > table_.size()) rehash(table_.size() * 2);
    return index;
  }

  std::int64_t bytes() const noexcept {
    return static_cast<std::int64_t>(corners_.capacity() * sizeof(Corner) +
                                     table_.capacity() * sizeof(std::uint64_t));
  }

 private:
  static constexpr std::size_t kSmallest = 256;
  static constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio

  // Tile by tile, 8 x 8 lattice points each: below 2^31 for every map.
  std::uint64_t place_of(int x, int y) const noexcept {
    const auto tile =
        static_cast<std::uint64_t>(y >> 3) * tiles_ + static_cast<std::uint64_t>(x >> 3);
    return tile << 6 | static_cast<std::uint64_t>((y & 7) << 3 | (x & 7));
  }
  // The points of a tile have slots in a row, eight a cache line: neighbours are looked up
  // together.
  std::size_t home(std::uint64_t place) const noexcept {
    const std::size_t first = ((place >> 6) * kMultiplier) >> shift_ << 3;
    return (first + (place & 63)) & (table_.size() - 1);
  }

  void rehash(std::size_t size) {
    table_.assign(size, 0);
    shift_ = 64 + 3 - std::countr_zero(size);
    for (std::uint32_t i = 1; i < this->size(); ++i) {
      const int x = corners_[i].x >> 1;
      const int y = corners_[i].y >> 1;
      table_[slot(x, y)] = place_of(x, y) << 32 | i;
    }
  }

  std::vector<Corner> corners_;
  std::vector<std::uint64_t> table_;  // place << 32 | index; 0: empty
  std::uint64_t tiles_ = 1;           // in a row of tiles
  int shift_ = 0;
};

}  // namespace lasius::exact
