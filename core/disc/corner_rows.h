// The corners of blocked cells, as rows of bits and by number.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/disc/grown_rows.h"
#include "lasius/grid/grid.h"

namespace lasius::disc {

/// The lattice points around a part of a map with exactly one blocked cell around them, by type.
class CornerRows {
 public:
  CornerRows(const Grid& grid, const Words& part);

  struct Corner {
    std::uint16_t x, y;
    std::uint32_t type;
  };
  /// By number: those of eight rows of a word stand together.
  const std::vector<Corner>& corners() const noexcept { return corners_; }
  /// The number of a corner of the part.
  std::uint32_t number(int x, int y) const noexcept;
  /// Is a lattice point of the part a corner?
  bool corner(int x, int y) const noexcept {
    const Word& word = words_[at(x >> 6, y)];
    return ((word[0] | word[1] | word[2] | word[3]) >> (x & 63) & 1) != 0;
  }
  /// 64 bits from lattice point (x, y) on: corners of a type. None in other rows, nor farther than
  /// a word from the part; -64 <= x.
  std::uint64_t window(std::uint32_t type, int x, int y) const noexcept {
    if (y < part_.top || y > part_.bottom) return 0;
    const Word* word = words_.data() + at(x >> 6, y);
    const int shift = x & 63;
    return word[0][type] >> shift | word[1][type] << 1 << (63 - shift);
  }

 private:
  using Word = std::array<std::uint64_t, 4>;

  std::size_t at(int word, int y) const noexcept {
    return static_cast<std::size_t>(y - part_.top) * stride_ +
           static_cast<std::size_t>(word + 1 - part_.first);
  }

  const Words part_;
  const std::size_t stride_;  // words a row, one of them before its first
  std::vector<Word> words_;
  std::vector<std::uint32_t> ranks_;  // corners before a word, of any type
  std::vector<Corner> corners_;
};

}  // namespace lasius::disc
