// One ant's draw with AVX2: a row in registers of eight weights each; one of four moves leaves the
// upper half of its register 0.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "kernels/walk/avx2_vectors.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

class RowDraw {
 public:
  /// As ScalarOps::roulette.
  template <int kLanes, bool kMixture, bool kFactor>
  LASIUS_AVX2 [[gnu::always_inline]] static int roulette(const WalkWorld& world, const float* row,
                                                         std::uint32_t open, std::uint32_t previous,
                                                         std::uint32_t random) noexcept {
    constexpr int kParts = (kLanes + 7) / 8;
    int rule = random < world.rule_start[kPheromoneRule] ? kGreedyRule : kCombinedRule;
    if constexpr (kMixture) {
      rule = (random >= world.rule_start[kPheromoneRule]) +
             (random >= world.rule_start[kDistanceRule]) +
             (random >= world.rule_start[kCombinedRule]);
    }
    const __m256 zero = _mm256_setzero_ps();
    __m256 weight[kParts];
    std::uint32_t positive = 0;
    for (int part = 0; part < kParts; ++part) {
      const int k = part * 8;
      __m256 w = weights<kLanes, kFactor>(world, row, previous, k);
      if constexpr (kMixture) {
        const __m256 distance = eight_of<kLanes>(row + kLanes + k);
        const __m256 combined = _mm256_mul_ps(w, distance);
        w = choose(w, distance, everywhere_if(rule == kDistanceRule));
        w = choose(w, combined, everywhere_if(rule == kCombinedRule || rule == kGreedyRule));
      }
      weight[part] = only(w, open >> k);
      positive |= less_bits(zero, weight[part]) << k;
    }
    if (positive == 0) [[unlikely]]
      return -1;
    if (rule == kGreedyRule) return first_largest(weight, positive);

    __m256 sums[kParts];
    sums[0] = prefix<kLanes>(weight[0]);
    for (int part = 1; part < kParts; ++part) {
      sums[part] = _mm256_add_ps(prefix<kLanes>(weight[part]), total<kLanes>(sums[part - 1]));
    }
    const auto rest = random - static_cast<std::uint32_t>(world.rule_start[rule]);
    const float share = static_cast<float>(rest) * world.rule_scale[rule];
    const __m256 threshold = _mm256_mul_ps(_mm256_set1_ps(share), total<kLanes>(sums[kParts - 1]));
    std::uint32_t hit = 0;
    for (int part = 0; part < kParts; ++part) {
      hit |= less_bits(threshold, sums[part]) << (part * 8);
    }
    hit &= positive;
    if (hit == 0) [[unlikely]]
      return 31 - __builtin_clz(positive);
    return __builtin_ctz(hit);
  }

  /// As ScalarOps::race.
  template <int kLanes, bool kFactor>
  LASIUS_AVX2 [[gnu::always_inline]] static int race(const WalkWorld& world, const float* row,
                                                     std::uint32_t open, std::uint32_t previous,
                                                     const float* at_weight_one) noexcept {
    constexpr int kParts = (kLanes + 7) / 8;
    __m256 time[kParts];
    std::uint32_t running = 0;
    for (int part = 0; part < kParts; ++part) {
      const int k = part * 8;
      const __m256 mean = weights<kLanes, kFactor>(world, row, previous, k);
      time[part] = only(_mm256_mul_ps(eight_of<kLanes>(at_weight_one + k), mean), open >> k);
      running |= less_bits(_mm256_setzero_ps(), time[part]) << k;
    }
    if (running == 0) [[unlikely]]
      return -1;
    return first_largest(time, running);
  }

  /// As ScalarOps::bits_at.
  LASIUS_AVX2 [[gnu::always_inline]] static std::uint32_t bits_at(std::uint64_t word,
                                                                  std::uint64_t mask) noexcept {
    return static_cast<std::uint32_t>(_pext_u64(word, mask));
  }

 private:
  /// Eight floats of a row with so many moves, of which four are all that there are.
  template <int kLanes>
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 eight_of(const float* row) noexcept {
    if constexpr (kLanes == 4) return _mm256_zextps128_ps256(_mm_load_ps(row));
    return _mm256_load_ps(row);
  }
  /// Of moves k to k + 7, times the factors.
  template <int kLanes, bool kFactor>
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 weights(const WalkWorld& world, const float* row,
                                                           std::uint32_t previous, int k) noexcept {
    const __m256 w = eight_of<kLanes>(row + k);
    if constexpr (!kFactor) return w;
    return _mm256_mul_ps(w, eight_of<kLanes>(world.factor[previous].data() + k));
  }
  LASIUS_AVX2 [[gnu::always_inline]] static __m256i everywhere_if(bool set) noexcept {
    return all(-std::uint32_t{set});
  }
  /// The lanes whose bits are set, 0 in the others.
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 only(__m256 v, std::uint32_t set) noexcept {
#if defined(LASIUS_AVX512)
    return _mm256_maskz_mov_ps(static_cast<__mmask8>(set), v);
#else
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i mask = _mm256_cmpeq_epi32(_mm256_and_si256(all(set), bit), bit);
    return _mm256_and_ps(v, _mm256_castsi256_ps(mask));
#endif
  }
  /// Bit k: a < b in lane k.
  LASIUS_AVX2 [[gnu::always_inline]] static std::uint32_t less_bits(__m256 a, __m256 b) noexcept {
#if defined(LASIUS_AVX512)
    return _mm256_cmp_ps_mask(a, b, _CMP_LT_OQ);
#else
    return bits(less(a, b));
#endif
  }
  /// Prefix sums in the order of the scalar reference; of four moves, in the lower half.
  template <int kLanes>
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 prefix(__m256 v) noexcept {
    v = _mm256_add_ps(v, shifted<4>(v));
    v = _mm256_add_ps(v, shifted<8>(v));
    if constexpr (kLanes == 4) return v;
    const __m256 lower_total = _mm256_permute2f128_ps(v, v, 0x08);  // upper half: lower half
    return _mm256_add_ps(v, _mm256_shuffle_ps(lower_total, lower_total, 0xff));
  }
  template <int kBytes>
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 shifted(__m256 v) noexcept {
    return _mm256_castsi256_ps(_mm256_slli_si256(_mm256_castps_si256(v), kBytes));
  }
  /// The last of the sums, in every lane that has one.
  template <int kLanes>
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 total(__m256 sums) noexcept {
    if constexpr (kLanes == 4) return _mm256_shuffle_ps(sums, sums, 0xff);
    return _mm256_permutevar8x32_ps(sums, all(7));
  }
  /// The first of the lanes set in `among` that holds the largest value of all.
  template <int kParts>
  LASIUS_AVX2 [[gnu::always_inline]] static int first_largest(const __m256 (&value)[kParts],
                                                              std::uint32_t among) noexcept {
    __m256 most = value[0];
    for (int part = 1; part < kParts; ++part) most = _mm256_max_ps(most, value[part]);
    most = _mm256_max_ps(most, _mm256_permute2f128_ps(most, most, 1));
    most = _mm256_max_ps(most, _mm256_shuffle_ps(most, most, 0x4e));
    most = _mm256_max_ps(most, _mm256_shuffle_ps(most, most, 0xb1));
    std::uint32_t below = 0;
    for (int part = 0; part < kParts; ++part) {
      below |= less_bits(value[part], most) << (part * 8);
    }
    return __builtin_ctz(among & ~below);
  }
};

}  // namespace
}  // namespace lasius::kernels
