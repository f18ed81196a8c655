// Runs of free and blocked cells in a bit row, found a word at a time.
#pragma once

#include <bit>
#include <cstdint>

namespace lasius::peers {

inline bool bit(const std::uint64_t* row, int x) noexcept { return (row[x >> 6] >> (x & 63)) & 1; }

/// True when no column from `first` to `last` is blocked.
inline bool run_free(const std::uint64_t* row, std::int64_t first, std::int64_t last) noexcept {
  const std::int64_t i = first >> 6, j = last >> 6;
  const std::uint64_t head = ~std::uint64_t{0} << (first & 63);
  const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (last & 63));
  if (i == j) return (row[i] & head & tail) == 0;
  if ((row[i] & head) != 0 || (row[j] & tail) != 0) return false;
  for (std::int64_t w = i + 1; w < j; ++w) {
    if (row[w] != 0) return false;
  }
  return true;
}

/// The first blocked column >= x; the border ends every row.
inline int first_blocked(const std::uint64_t* row, int x) noexcept {
  int i = x >> 6;
  std::uint64_t word = row[i] >> (x & 63);
  if (word != 0) return x + std::countr_zero(word);
  while ((word = row[++i]) == 0) {
  }
  return i * 64 + std::countr_zero(word);
}

/// The last blocked column <= x, -1 for the border.
inline int last_blocked(const std::uint64_t* row, int x) noexcept {
  int i = x >> 6;
  std::uint64_t word = row[i] << (63 - (x & 63));
  if (word != 0) return x - std::countl_zero(word);
  while ((word = row[--i]) == 0) {
  }
  return i * 64 + 63 - std::countl_zero(word);
}

/// The first free column >= x, or `end` if there is none before it.
inline int first_free(const std::uint64_t* row, int x, int end) noexcept {
  if (x >= end) return end;
  int i = x >> 6;
  std::uint64_t word = ~row[i] >> (x & 63);
  if (word != 0) return x + std::countr_zero(word);
  const int last = (end - 1) >> 6;
  while (++i <= last) {
    word = ~row[i];
    if (word != 0) return i * 64 + std::countr_zero(word);
  }
  return end;
}

/// The first column right, or left, of x where either of two rows differs from its bit at x, not
/// both of which are blocked there.
template <bool kRight>
int first_change(const std::uint64_t* a, const std::uint64_t* b, int x) noexcept {
  const std::uint64_t flip_a = bit(a, x) ? ~std::uint64_t{0} : 0;
  const std::uint64_t flip_b = bit(b, x) ? ~std::uint64_t{0} : 0;
  const std::uint64_t beyond =
      kRight ? ~std::uint64_t{0} << (x & 63) : ~std::uint64_t{0} >> (63 - (x & 63));
  int i = x >> 6;
  std::uint64_t word = ((a[i] ^ flip_a) | (b[i] ^ flip_b)) & beyond;
  while (word == 0) {
    i += kRight ? 1 : -1;
    word = (a[i] ^ flip_a) | (b[i] ^ flip_b);
  }
  return i * 64 + (kRight ? std::countr_zero(word) : 63 - std::countl_zero(word));
}

}  // namespace lasius::peers
