// Raw views of the data that kernels work on.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lasius::kernels {

/// A bitmap of blocked cells: cell (x, y) is bit x % 64 of origin[y * stride + x / 64], 1 =
/// blocked. Bits past the width are blocked, and so are the words around the cells, all of them
/// readable: words -1 and (width + 63) / 64 of a row, and the rows -1 and height.
struct BitmapView {
  const std::uint64_t* origin;
  std::ptrdiff_t stride;  ///< words from one row to the next
  int width;
  int height;

  /// Words of row y, -1 <= y <= height.
  const std::uint64_t* row(int y) const noexcept { return origin + y * stride; }
  /// -1 <= x <= width, -1 <= y <= height.
  bool blocked(int x, int y) const noexcept { return ((row(y)[x >> 6] >> (x & 63)) & 1) != 0; }
};

}  // namespace lasius::kernels
