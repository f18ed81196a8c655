// Eight ants in registers of AVX-512. The including file defines LASIUS_TARGET with its F, VL, DQ,
// BW.
//
// Two layouts: "one an ant", a number of 64 bits for each of the eight; and "in halves", 16 floats
// or integers: for ants 0 to 3 move j, for the same ants move j + 4 (a number of the ant itself
// stands in both), then both for ants 4 to 7. Four registers in halves, j = 0 to 3, are the rows of
// eight ants. A row of four moves by two rules (kMixture) has the moves in both halves once mixed.
#pragma once

#include <Random123/philox.h>
#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>

#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// Of 64 bits each; aligned to 64 bytes where it is loaded or stored.
template <class T>
using PerAnt = std::array<T, 8>;

/// For AbreastAnts.
struct Lanes {
  using Number = std::uint64_t;
  static constexpr int place(int i) noexcept { return i; }
};

template <class T>
LASIUS_TARGET [[gnu::always_inline]] inline __m512i load(const PerAnt<T>& a) noexcept {
  return _mm512_load_si512(a.data());
}
template <class T>
LASIUS_TARGET [[gnu::always_inline]] inline void store(PerAnt<T>& a, __m512i v) noexcept {
  _mm512_store_si512(a.data(), v);
}
LASIUS_TARGET [[gnu::always_inline]] inline __m512i all(std::int64_t x) noexcept {
  return _mm512_set1_epi64(x);
}
LASIUS_TARGET [[gnu::always_inline]] inline __m512i eight(__m128i a, __m128i b, __m128i c,
                                                          __m128i d) noexcept {
  return _mm512_inserti64x4(
      _mm512_castsi256_si512(_mm256_inserti128_si256(_mm256_castsi128_si256(a), b, 1)),
      _mm256_inserti128_si256(_mm256_castsi128_si256(c), d, 1), 1);
}
template <class T>
LASIUS_TARGET [[gnu::always_inline]] inline __m128i two(T low, T high) noexcept {
  return _mm_insert_epi64(_mm_cvtsi64_si128(std::bit_cast<long long>(low)),
                          std::bit_cast<long long>(high), 1);
}

LASIUS_TARGET [[gnu::always_inline]] inline __m512i in_halves(__m512i one_an_ant) noexcept {
  return _mm512_permutexvar_epi32(
      _mm512_setr_epi32(0, 2, 4, 6, 0, 2, 4, 6, 8, 10, 12, 14, 8, 10, 12, 14), one_an_ant);
}
LASIUS_TARGET [[gnu::always_inline]] inline __m512i one_an_ant(__m512i halves) noexcept {
  return _mm512_permutexvar_epi32(
      _mm512_setr_epi32(0, 0, 1, 0, 2, 0, 3, 0, 8, 0, 9, 0, 10, 0, 11, 0), halves);
}
/// One number for the first half's moves, one for the second's; four moves stand in both.
template <bool kMixture>
LASIUS_TARGET [[gnu::always_inline]] inline __m512i by_half(int a, int b) noexcept {
  if constexpr (kMixture) return _mm512_set1_epi32(a);
  return _mm512_setr_epi32(a, a, a, a, b, b, b, b, a, a, a, a, b, b, b, b);
}
/// The first half's values in both, or the second's.
LASIUS_TARGET [[gnu::always_inline]] inline __m512 first_half(__m512 v) noexcept {
  return _mm512_shuffle_f32x4(v, v, 0b10'10'00'00);
}
LASIUS_TARGET [[gnu::always_inline]] inline __m512 second_half(__m512 v) noexcept {
  return _mm512_shuffle_f32x4(v, v, 0b11'11'01'01);
}

LASIUS_TARGET [[gnu::always_inline]] inline __m512i second_half_turned(__m512i halves) noexcept {
  constexpr __mmask16 kSecond = 0xf0f0;
  return _mm512_mask_rol_epi32(halves, kSecond, halves, 16);
}

/// The blocks of Philox4x32-10 with these counters, one an ant; the upper halves are undefined. (As
/// are those of its products' factors, which the multiplication ignores.)
LASIUS_TARGET [[gnu::always_inline]] inline void philox(const WalkWorld& world, __m512i block,
                                                        __m512i ant, __m512i (&words)[4]) noexcept {
  const __m512i multiplier0 = all(PHILOX_M4x32_0), multiplier1 = all(PHILOX_M4x32_1);
  auto key0 = static_cast<std::uint32_t>(world.seed);
  auto key1 = static_cast<std::uint32_t>(world.seed >> 32);
  __m512i c0 = block, c1 = ant, c2 = all(world.iteration), c3 = all(0);
  for (int round = 0; round < 10; ++round) {
    const __m512i product0 = _mm512_mul_epu32(c0, multiplier0);
    const __m512i product1 = _mm512_mul_epu32(c2, multiplier1);
    constexpr int kXor = 0x96;  // of three
    c0 = _mm512_ternarylogic_epi64(_mm512_srli_epi64(product1, 32), c1, all(key0), kXor);
    c2 = _mm512_ternarylogic_epi64(_mm512_srli_epi64(product0, 32), c3, all(key1), kXor);
    c1 = product1;
    c3 = product0;
    key0 += PHILOX_W32_0;
    key1 += PHILOX_W32_1;
  }
  words[0] = c0;
  words[1] = c1;
  words[2] = c2;
  words[3] = c3;
}

}  // namespace
}  // namespace lasius::kernels
