// Registers of AVX2 as the walk uses them: eight numbers of 32 bits. In the lock-step walk a lane
// is an ant; what takes 64 bits an ant, mostly pointers, stands in two registers (Wide): of the
// even ants, then of the odd ones, so that going from one layout to the other crosses no lane.
#pragma once

#include <Random123/philox.h>
#include <immintrin.h>

#include <array>
#include <cstdint>

#include "kernels/walk/walk.h"

/// The attribute of every function that is compiled for AVX2. walk_avx512.cpp defines LASIUS_AVX512
/// and compiles the same code for AVX-512, on registers of the same width.
#if defined(LASIUS_AVX512)
#define LASIUS_AVX2 [[gnu::target("avx512f,avx512vl,avx512dq,avx512bw,bmi,bmi2")]]
#else
#define LASIUS_AVX2 [[gnu::target("avx2,bmi,bmi2")]]
#endif

namespace lasius::kernels {
namespace {

/// A number an ant; aligned to 32 bytes where it is loaded or stored.
using PerAnt = std::array<std::uint32_t, 8>;

LASIUS_AVX2 [[gnu::always_inline]] inline __m256i load(const PerAnt& a) noexcept {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(a.data()));
}
LASIUS_AVX2 [[gnu::always_inline]] inline void store(PerAnt& a, __m256i v) noexcept {
  _mm256_store_si256(reinterpret_cast<__m256i*>(a.data()), v);
}
LASIUS_AVX2 [[gnu::always_inline]] inline __m256i all(std::uint32_t x) noexcept {
  return _mm256_set1_epi32(static_cast<int>(x));
}

// --- Masks: all bits of a lane set, or none

/// b where the mask is set, else a.
LASIUS_AVX2 [[gnu::always_inline]] inline __m256 choose(__m256 a, __m256 b, __m256i mask) noexcept {
  return _mm256_blendv_ps(a, b, _mm256_castsi256_ps(mask));
}
LASIUS_AVX2 [[gnu::always_inline]] inline __m256i choose(__m256i a, __m256i b,
                                                         __m256i mask) noexcept {
  return _mm256_castps_si256(choose(_mm256_castsi256_ps(a), _mm256_castsi256_ps(b), mask));
}
/// a < b, a == b of floats.
LASIUS_AVX2 [[gnu::always_inline]] inline __m256i less(__m256 a, __m256 b) noexcept {
  return _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_LT_OQ));
}
LASIUS_AVX2 [[gnu::always_inline]] inline __m256i equal(__m256 a, __m256 b) noexcept {
  return _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_EQ_OQ));
}
LASIUS_AVX2 [[gnu::always_inline]] inline bool any(__m256i mask) noexcept {
  return _mm256_testz_si256(mask, mask) == 0;
}
/// Bit i: that of ant i.
LASIUS_AVX2 [[gnu::always_inline]] inline unsigned bits(__m256i mask) noexcept {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(mask)));
}

// --- 64 bits an ant

struct Wide {
  __m256i even, odd;
};
/// As PerAnt, in the order of Wide.
template <class T>
using PerAntWide = std::array<T, 8>;

/// Where ant i stands in the order of Wide.
constexpr int place(int i) noexcept { return i / 2 + i % 2 * 4; }

template <class T>
LASIUS_AVX2 [[gnu::always_inline]] inline Wide load_wide(const PerAntWide<T>& a) noexcept {
  return {_mm256_load_si256(reinterpret_cast<const __m256i*>(a.data())),
          _mm256_load_si256(reinterpret_cast<const __m256i*>(a.data() + 4))};
}
template <class T>
LASIUS_AVX2 [[gnu::always_inline]] inline void store_wide(PerAntWide<T>& a, Wide v) noexcept {
  _mm256_store_si256(reinterpret_cast<__m256i*>(a.data()), v.even);
  _mm256_store_si256(reinterpret_cast<__m256i*>(a.data() + 4), v.odd);
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide widen(__m256i v) noexcept {
  return {_mm256_blend_epi32(v, _mm256_setzero_si256(), 0xaa), _mm256_srli_epi64(v, 32)};
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide widen_mask(__m256i v) noexcept {
  return {_mm256_shuffle_epi32(v, 0xa0), _mm256_shuffle_epi32(v, 0xf5)};
}
/// The lower halves.
LASIUS_AVX2 [[gnu::always_inline]] inline __m256i narrow(Wide v) noexcept {
  return _mm256_blend_epi32(v.even, _mm256_slli_epi64(v.odd, 32), 0xaa);
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide all_wide(std::int64_t x) noexcept {
  return {_mm256_set1_epi64x(x), _mm256_set1_epi64x(x)};
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide plus(Wide a, Wide b) noexcept {
  return {_mm256_add_epi64(a.even, b.even), _mm256_add_epi64(a.odd, b.odd)};
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide minus(Wide a, Wide b) noexcept {
  return {_mm256_sub_epi64(a.even, b.even), _mm256_sub_epi64(a.odd, b.odd)};
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide equal(Wide a, Wide b) noexcept {
  return {_mm256_cmpeq_epi64(a.even, b.even), _mm256_cmpeq_epi64(a.odd, b.odd)};
}
LASIUS_AVX2 [[gnu::always_inline]] inline Wide choose(Wide a, Wide b, Wide mask) noexcept {
  return {_mm256_blendv_epi8(a.even, b.even, mask.even),
          _mm256_blendv_epi8(a.odd, b.odd, mask.odd)};
}

// --- Random numbers

/// As `turned` of one word (race.h).
LASIUS_AVX2 [[gnu::always_inline]] inline __m256i turned(__m256i words) noexcept {
  return _mm256_or_si256(_mm256_slli_epi32(words, 16), _mm256_srli_epi32(words, 16));
}
/// The blocks of Philox4x32-10 with these counters. The products read the lower halves of 64 bits
/// alone, so that what stands above them (the odd ants) does not matter.
LASIUS_AVX2 [[gnu::always_inline]] inline void philox(const WalkWorld& world, __m256i block,
                                                      __m256i ant, __m256i (&words)[4]) noexcept {
  const __m256i multiplier0 = all(PHILOX_M4x32_0), multiplier1 = all(PHILOX_M4x32_1);
  const __m256i iteration = all(world.iteration), zero = all(0);
  __m256i halves[2][4] = {
      {block, ant, iteration, zero},
      {_mm256_srli_epi64(block, 32), _mm256_srli_epi64(ant, 32), iteration, zero}};
  auto key0 = static_cast<std::uint32_t>(world.seed);
  auto key1 = static_cast<std::uint32_t>(world.seed >> 32);
  for (int round = 0; round < 10; ++round) {
    for (auto& c : halves) {
      const __m256i product0 = _mm256_mul_epu32(c[0], multiplier0);
      const __m256i product1 = _mm256_mul_epu32(c[2], multiplier1);
      c[0] = _mm256_xor_si256(_mm256_srli_epi64(product1, 32), _mm256_xor_si256(c[1], all(key0)));
      c[2] = _mm256_xor_si256(_mm256_srli_epi64(product0, 32), _mm256_xor_si256(c[3], all(key1)));
      c[1] = product1;
      c[3] = product0;
    }
    key0 += PHILOX_W32_0;
    key1 += PHILOX_W32_1;
  }
  for (int w = 0; w < 4; ++w) words[w] = narrow({halves[0][w], halves[1][w]});
}

}  // namespace
}  // namespace lasius::kernels
