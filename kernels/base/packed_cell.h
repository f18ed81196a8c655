// A cell in one word.
#pragma once

#include <cstdint>

namespace lasius::kernels {

/// A cell packed into one word: y in the upper half, x in the lower; both below 32768.
using PackedCell = std::uint32_t;
constexpr PackedCell pack(int x, int y) noexcept {
  return static_cast<PackedCell>(y) << 16 | static_cast<PackedCell>(x);
}
constexpr int packed_x(PackedCell c) noexcept { return static_cast<int>(c & 0xffff); }
constexpr int packed_y(PackedCell c) noexcept { return static_cast<int>(c >> 16); }

}  // namespace lasius::kernels
