// A map as columns of words: the rows of 64 columns lie side by side, so that one shift serves a
// whole mask.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/grid/grid.h"

namespace lasius::vehicle {

/// Bit x % 64 of word(x / 64, y) is 1 where cell (x, y) is blocked. Beyond the map are `margin`
/// columns and rows of ones and more.
class BitColumns {
 public:
  BitColumns(const Grid& grid, int margin);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }

  /// The words of 64 columns from row y on, of which `column` and `column` + 1 are readable for
  /// columns and rows up to the margin beyond the map. Precondition: x >= -margin.
  const std::uint64_t* from(int x, int y) const noexcept {
    return bits_.data() + static_cast<std::ptrdiff_t>((x + left_) >> 6) * rows_ + (y + top_);
  }
  std::ptrdiff_t rows() const noexcept { return rows_; }  ///< words from a column to the next
  int shift(int x) const noexcept { return (x + left_) & 63; }

  /// Whether a cell of the row is blocked or outside, from column `first` to `last`.
  bool any_blocked(int y, int first, int last) const noexcept {
    if (y < 0 || y >= height_ || first < 0 || last >= width_) return true;
    const int word = first >> 6;
    const int end = last >> 6;
    const std::uint64_t* at = from(first, y);
    const std::uint64_t head = ~std::uint64_t{0} << (first & 63);
    const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (last & 63));
    if (word == end) return (*at & head & tail) != 0;
    if ((*at & head) != 0) return true;
    at += rows_;
    for (int w = word + 1; w < end; ++w, at += rows_) {
      if (*at != 0) return true;
    }
    return (*at & tail) != 0;
  }

 private:
  int width_, height_;
  int left_, top_;  ///< columns (a multiple of 64) and rows before the map
  std::ptrdiff_t rows_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace lasius::vehicle
