// The bitmap that every grid planner works on.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// What a byte other than 0 says of its cell; 0 says the other.
enum class Nonzero {
  blocked,  ///< as in an obstacle mask
  free,     ///< as in a mask of free space
};
/// The name, as in "blocked".
constexpr std::string_view to_string(Nonzero nonzero) noexcept {
  return nonzero == Nonzero::blocked ? "blocked" : "free";
}

/// A bitmap of free and blocked cells, one bit per cell (1 = blocked), with a border of blocked
/// bits all around so that neighbours need no bounds check.
///
/// Layout: row y is `words()` 64-bit words; cell x is bit x % 64 of word x / 64. Bits past the
/// width are blocked, so are word -1, word `words()`, row -1 and row `height()`, all readable.
class LASIUS_EXPORT Grid {
 public:
  /// The largest width and height. Every exactness argument in the library is made for this size.
  static constexpr int kMaxSide = 32768;

  /// A grid of free cells. @throws Error(invalid_parameter) unless 1 <= width, height <= kMaxSide.
  Grid(int width, int height);
  /// A grid from one byte per cell, row by row from the top left. Packs 8 cells at a time: 4096 x
  /// 4096 in a few milliseconds. @throws as above, and unless there are width x height bytes.
  Grid(int width, int height, std::span<const std::uint8_t> cells, Nonzero nonzero);

  Grid(const Grid&) = default;
  Grid& operator=(const Grid&) = default;
  Grid(Grid&& other) noexcept;  ///< leaves `other` without cells, 0 x 0
  Grid& operator=(Grid&& other) noexcept;
  ~Grid() = default;

  int width() const noexcept { return width_; }    ///< in cells
  int height() const noexcept { return height_; }  ///< in cells

  /// True for the cells of the grid.
  bool contains(Cell c) const noexcept {
    return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_;
  }
  /// True for blocked cells and for everything outside.
  bool blocked(Cell c) const noexcept {
    return !contains(c) || ((row(c.y)[c.x >> 6] >> (c.x & 63)) & 1) != 0;
  }
  /// True for free cells.
  bool free(Cell c) const noexcept { return !blocked(c); }

  /// Sets one cell. Precondition: contains(c).
  void set_blocked(Cell c, bool blocked = true) noexcept;
  /// Blocks or frees all cells of a rectangle. This, `paste` and `bytes` throw
  /// Error(invalid_parameter) for a rectangle that is not inside, or bytes that do not fit it.
  void fill(const Rectangle& part, bool blocked);
  /// Blocks or frees all cells.
  void fill(bool blocked) { fill({0, 0, width_, height_}, blocked); }
  /// Sets the cells of a rectangle from bytes, row by row, `part.width` per row.
  void paste(const Rectangle& part, std::span<const std::uint8_t> cells, Nonzero nonzero);
  /// The cells of a rectangle as bytes 0 and 1, likewise.
  std::vector<std::uint8_t> bytes(const Rectangle& part, Nonzero nonzero) const;
  /// All cells as bytes.
  std::vector<std::uint8_t> bytes(Nonzero nonzero) const {
    return bytes({0, 0, width_, height_}, nonzero);
  }

  int words() const noexcept { return words_; }       ///< words that hold cells, per row
  int stride() const noexcept { return words_ + 1; }  ///< words from one row to the next
  /// Words of row y, y in [-1, height()]; indices -1 .. words() are readable.
  const std::uint64_t* row(int y) const noexcept {
    return bits_.data() + (static_cast<std::int64_t>(y) + 1) * stride() + 1;
  }
  /// Replaces row y by `words()` words; bits past the width are ignored.
  void set_row(int y, const std::uint64_t* words) noexcept;

  /// The number of free cells. Looks at every word.
  std::int64_t count_free() const noexcept;
  /// 64-bit fingerprint of size and bits, the same on every machine: the map's hash in results.
  std::uint64_t hash() const noexcept;

  friend bool operator==(const Grid&, const Grid&) = default;

 private:
  std::uint64_t* mutable_row(int y) noexcept { return const_cast<std::uint64_t*>(row(y)); }
  void check_inside(const Rectangle& part) const;

  int width_;
  int height_;
  int words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace lasius
