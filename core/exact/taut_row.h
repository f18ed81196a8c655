// How far corners are from one end of a question, and over which corners.
#pragma once

#include <cstdint>
#include <vector>

namespace lasius::exact {

/// Corners with the shortest ways to them from one end, of those over which a way to the other end
/// may be shorter than a bound: length and straight distance left are less than it.
struct TautRow {
  static constexpr std::uint32_t kEnd = ~std::uint32_t{0};  ///< as a parent
  struct Corner {
    int x, y;              ///< of the lattice
    double length;         ///< from the end
    std::uint32_t parent;  ///< in the row: the corner before it
  };
  std::vector<Corner> corners;
};

}  // namespace lasius::exact
