// Rows of bits with blocked bits around them, seen from one column.
#pragma once

#include <bit>
#include <cstdint>

namespace lasius::disc {

/// 64 bits of a row from column x on, -64 <= x.
inline std::uint64_t bits_from(const std::uint64_t* row, int x) noexcept {
  const std::uint64_t* word = row + (x >> 6);
  const int shift = x & 63;
  return shift == 0 ? word[0] : word[0] >> shift | word[1] << (64 - shift);
}

/// The first column from x on that is set, x + 64 if there is none before it.
inline int blocked_after(const std::uint64_t* row, int x) noexcept {
  return x + std::countr_zero(bits_from(row, x));
}
/// The last column up to x that is set, x - 64 if there is none after it.
inline int blocked_before(const std::uint64_t* row, int x) noexcept {
  return x - std::countl_zero(bits_from(row, x - 63));
}

}  // namespace lasius::disc
