// Rows of bits with blocked bits around them, seen from one column.
#pragma once

#include <bit>
#include <cstdint>

namespace lasius::disc {

/// std::popcount, without a call where the processor may lack it.
inline std::uint32_t count_bits(std::uint64_t bits) noexcept {
  bits -= bits >> 1 & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<std::uint32_t>(bits * 0x0101010101010101 >> 56);
}

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
