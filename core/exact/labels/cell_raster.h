// The cells whose centres a corner sees in a quadrant, in whole numbers.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "kernels/sight/views.h"

namespace lasius::exact {

/// Slopes, columns a line, from left_columns / left_lines to the right one; 1 / 0 is level.
struct SlopeRange {
  std::int64_t left_columns, left_lines;
  std::int64_t right_columns, right_lines;
};

/// Looks from a lattice point to larger x, row by row. Between two rays that bound what is still
/// seen no blocked cell lies; a ray on the bound touches blocked cells on one side only, so that
/// what lies on it is seen. Sight without width is left out: there a path goes straight on at a
/// corner between.
class CellRaster {
 public:
  /// Calls span(row, first, last) for the columns of a row whose cells' centres are seen from
  /// lattice point (x, y), rows below it for down = 1, above it for -1, nearest first.
  template <class Span>
  std::int64_t run(const kernels::BitmapView& map, int x, int y, int down, const Span& span) {
    ranges_.assign(1, {0, 1, 1, 0});
    std::int64_t words = 0;
    for (std::int64_t j = 0; !ranges_.empty(); ++j) {
      const int row = down > 0 ? y + static_cast<int>(j) : y - 1 - static_cast<int>(j);
      if (row < 0 || row >= map.height) break;
      next_.clear();
      for (const SlopeRange& range : ranges_)
        words += cut(map.row(row), map.width, x, row, j, range, span);
      ranges_.swap(next_);
    }
    return words;
  }

 private:
  template <class Span>
  std::int64_t cut(const std::uint64_t* bits, int width, int x, int row, std::int64_t j,
                   const SlopeRange& range, const Span& span) {
    std::int64_t words = 1;
    const std::int64_t columns = width - x;
    // The last column that a ray enters the row in, one past it where it stands on a line.
    const std::int64_t entered =
        j == 0 ? 0
               : (range.right_lines == 0 ? columns : range.right_columns * j / range.right_lines);
    std::int64_t p = range.left_columns * j / range.left_lines;
    while (p <= entered && p < columns) {
      const std::int64_t free = next(bits, x + p, width, 0) - x;
      SlopeRange part = range;
      if (free > p) {
        if (j == 0 || free >= columns) break;
        // Is free / j right of the left bound? Then it is the bound.
        if (free * range.left_lines > range.left_columns * j) {
          part.left_columns = free;
          part.left_lines = j;
        }
      }
      if (part.right_lines != 0 &&
          part.left_columns * part.right_lines >= part.right_columns * part.left_lines)
        break;
      if (part.right_lines == 0 && part.left_lines == 0) break;
      const std::int64_t end = next(bits, x + free, width, 1) - x;
      words += 1 + ((end - free) >> 6);
      // Centres: slope (2 k + 1) / (2 j + 1).
      const std::int64_t centre = 2 * j + 1;
      const std::int64_t low = part.left_columns * centre - part.left_lines;
      const std::int64_t step = 2 * part.left_lines;
      std::int64_t first = low <= 0 ? 0 : (low + step - 1) / step;
      first = std::max(first, free);
      std::int64_t last = end - 1;
      if (part.right_lines != 0) {
        const std::int64_t high = part.right_columns * centre - part.right_lines;
        last = high < 0 ? -1 : std::min(last, high / (2 * part.right_lines));
      }
      if (first <= last) span(row, static_cast<int>(x + first), static_cast<int>(x + last));
      // What leaves the row through its far line before the run ends.
      if (part.right_lines == 0 || end * part.right_lines < part.right_columns * (j + 1)) {
        part.right_columns = end;
        part.right_lines = j + 1;
      }
      if (part.left_columns * part.right_lines < part.right_columns * part.left_lines)
        next_.push_back(part);
      p = end;
      if (j == 0) break;
    }
    return words;
  }

  // The first column from x on, at most `width`, whose bit is `value` (1: blocked).
  static std::int64_t next(const std::uint64_t* bits, std::int64_t x, int width, int value) {
    const std::uint64_t flip = value != 0 ? 0 : ~std::uint64_t{0};
    for (std::int64_t word = x >> 6;; ++word) {
      std::uint64_t found = bits[word] ^ flip;
      if (word == x >> 6) found &= ~std::uint64_t{0} << (x & 63);
      if (found != 0) return std::min<std::int64_t>(word * 64 + std::countr_zero(found), width);
      if (word * 64 >= width) return width;
    }
  }

  std::vector<SlopeRange> ranges_, next_;
};

}  // namespace lasius::exact
