// Rows of bits seen in the direction of travel, and the fixed-point columns that scans work in.
//
// A scan runs away from its root row by row and never turns back sideways, so it works in mirrored
// columns u = S * x (S = +1 or -1) in which every ray runs towards larger u. Mirrored column c of
// cells covers [c, c + 1]: cell x = c for S = +1, x = -c - 1 for S = -1.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "kernels/sight/views.h"

namespace lasius::kernels {

static_assert(std::endian::native == std::endian::little, "windows are read bytewise");

/// A column with kFraction fractional bits; |columns| < 2^17 are exact sums.
using Fixed = std::int64_t;
constexpr int kFraction = 44;
constexpr Fixed kOne = Fixed{1} << kFraction;
constexpr std::int64_t kWordsAtOnce = 4096;  ///< that a scan reads between looks at the clock

constexpr Fixed fixed(int column) noexcept { return static_cast<Fixed>(column) << kFraction; }
constexpr int floor_column(Fixed u) noexcept { return static_cast<int>(u >> kFraction); }

inline const char* bytes_of(const std::uint64_t* row) noexcept {
  return reinterpret_cast<const char*>(row);
}

/// Bit windows: index i of window(row, c) stands for mirrored column c + i, 0 <= i < kValid.
template <int S>
struct Bits {
  static constexpr int kValid = 57;  ///< a window is cut from 8 bytes at any bit

  /// From the first byte of a row's word 0. c from -1 to the border, mirrored alike.
  static std::uint64_t window(const char* row, int column) noexcept {
    const std::uint64_t w = uncut(row, column);
    return S > 0 ? w >> (column & 7) : w << (7 - ((-column - 1) & 7));
  }
  /// The 8 bytes that window(row, column) is cut from.
  static std::uint64_t uncut(const char* row, int column) noexcept {
    std::uint64_t w;
    std::memcpy(&w, row + (S > 0 ? column >> 3 : ((-column - 1) >> 3) - 7), sizeof w);
    return w;
  }
  /// Where bits of such a window lie in them.
  static std::uint64_t to_uncut(std::uint64_t bits, int column) noexcept {
    return S > 0 ? bits << (column & 7) : bits >> (7 - ((-column - 1) & 7));
  }
  /// Indices i and up.
  static std::uint64_t from(int i) noexcept {
    return S > 0 ? ~std::uint64_t{0} << i : ~std::uint64_t{0} >> i;
  }
  /// Indices up to i.
  static std::uint64_t to(int i) noexcept {
    return S > 0 ? ~std::uint64_t{0} >> (63 - i) : ~std::uint64_t{0} << (63 - i);
  }
  static constexpr std::uint64_t only(int i) noexcept {
    return S > 0 ? std::uint64_t{1} << i : std::uint64_t{1} << (63 - i);
  }
  /// What index i - 1 holds, at index i.
  static std::uint64_t previous(std::uint64_t w) noexcept { return S > 0 ? w << 1 : w >> 1; }
  /// The smallest index that is set; w != 0.
  static int first(std::uint64_t w) noexcept {
    return S > 0 ? std::countr_zero(w) : std::countl_zero(w);
  }
  /// The largest.
  static int last(std::uint64_t w) noexcept {
    return 63 - (S > 0 ? std::countl_zero(w) : std::countr_zero(w));
  }
};

/// The smallest mirrored column in [from, to] that is blocked (or free), to + 1 if there is none.
template <int S, bool kBlocked>
int next_cell(const char* row, int from, int to) noexcept {
  using B = Bits<S>;
  for (int c = from; c <= to; c += B::kValid) {
    std::uint64_t w = B::window(row, c);
    if constexpr (!kBlocked) w = ~w;
    w &= B::to(B::kValid - 1);
    if (w != 0) {
      const int found = c + B::first(w);
      return found <= to ? found : to + 1;
    }
  }
  return to + 1;
}

template <int S>
bool blocked_cell(const char* row, int column) noexcept {
  return (Bits<S>::window(row, column) & Bits<S>::only(0)) != 0;
}

}  // namespace lasius::kernels
