// The draw in vectors: a row of four or eight weights in one register. The including file defines
//   LASIUS_TARGET  the function attribute of its instruction set, at least AVX2
//   LASIUS_MASKS   1 where comparisons give bit masks (AVX-512), else 0

#include <immintrin.h>

#include "kernels/walk/walk_tables.h"

namespace lasius::kernels {
namespace {

/// Four or eight weights, their bits by lane, and sums in the order of the scalar reference.
template <int kLanes>
struct Row;

template <>
struct Row<4> {
  using V = __m128;
  LASIUS_TARGET [[gnu::always_inline]] static V load(const float* p) noexcept {
    return _mm_load_ps(p);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V only(V v, std::uint32_t open) noexcept {
#if LASIUS_MASKS
    return _mm_maskz_mov_ps(static_cast<__mmask8>(open), v);
#else
    return _mm_and_ps(v, spread(open));
#endif
  }
  LASIUS_TARGET [[gnu::always_inline]] static V times(V a, V b) noexcept {
    return _mm_mul_ps(a, b);
  }
  /// b where the mask's bits are set, else a.
  LASIUS_TARGET [[gnu::always_inline]] static V blend(V a, V b, int mask) noexcept {
    return _mm_blendv_ps(a, b, _mm_castsi128_ps(_mm_set1_epi32(mask)));
  }
  LASIUS_TARGET [[gnu::always_inline]] static V prefix(V v) noexcept {
    v = _mm_add_ps(v, shifted<4>(v));
    return _mm_add_ps(v, shifted<8>(v));
  }
  LASIUS_TARGET [[gnu::always_inline]] static V total(V sums) noexcept {
    return _mm_shuffle_ps(sums, sums, 0xff);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V all(float x) noexcept { return _mm_set1_ps(x); }
  LASIUS_TARGET [[gnu::always_inline]] static V plus(V a, V b) noexcept { return _mm_add_ps(a, b); }
  LASIUS_TARGET [[gnu::always_inline]] static V larger(V a, V b) noexcept {
    return _mm_max_ps(a, b);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V largest(V v) noexcept {
    v = _mm_max_ps(v, _mm_shuffle_ps(v, v, 0x4e));
    return _mm_max_ps(v, _mm_shuffle_ps(v, v, 0xb1));
  }
  LASIUS_TARGET [[gnu::always_inline]] static std::uint32_t less(V a, V b) noexcept {
#if LASIUS_MASKS
    return _mm_cmp_ps_mask(a, b, _CMP_LT_OQ);
#else
    return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmplt_ps(a, b)));
#endif
  }

 private:
#if !LASIUS_MASKS
  /// All bits of lane k set where bit k is.
  LASIUS_TARGET [[gnu::always_inline]] static V spread(std::uint32_t bits) noexcept {
    const __m128i bit = _mm_setr_epi32(1, 2, 4, 8);
    const __m128i on = _mm_and_si128(_mm_set1_epi32(static_cast<int>(bits)), bit);
    return _mm_castsi128_ps(_mm_cmpeq_epi32(on, bit));
  }
#endif
  template <int kBytes>
  LASIUS_TARGET [[gnu::always_inline]] static V shifted(V v) noexcept {
    return _mm_castsi128_ps(_mm_slli_si128(_mm_castps_si128(v), kBytes));
  }
};

template <>
struct Row<8> {
  using V = __m256;
  LASIUS_TARGET [[gnu::always_inline]] static V load(const float* p) noexcept {
    return _mm256_load_ps(p);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V only(V v, std::uint32_t open) noexcept {
#if LASIUS_MASKS
    return _mm256_maskz_mov_ps(static_cast<__mmask8>(open), v);
#else
    return _mm256_and_ps(v, spread(open));
#endif
  }
  LASIUS_TARGET [[gnu::always_inline]] static V times(V a, V b) noexcept {
    return _mm256_mul_ps(a, b);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V blend(V a, V b, int mask) noexcept {
    return _mm256_blendv_ps(a, b, _mm256_castsi256_ps(_mm256_set1_epi32(mask)));
  }
  LASIUS_TARGET [[gnu::always_inline]] static V prefix(V v) noexcept {
    v = _mm256_add_ps(v, shifted<4>(v));
    v = _mm256_add_ps(v, shifted<8>(v));
    const V lower_total = _mm256_permute2f128_ps(v, v, 0x08);  // upper half: lower half
    return _mm256_add_ps(v, _mm256_shuffle_ps(lower_total, lower_total, 0xff));
  }
  LASIUS_TARGET [[gnu::always_inline]] static V total(V sums) noexcept {
    return _mm256_permutevar8x32_ps(sums, _mm256_set1_epi32(7));
  }
  LASIUS_TARGET [[gnu::always_inline]] static V all(float x) noexcept { return _mm256_set1_ps(x); }
  LASIUS_TARGET [[gnu::always_inline]] static V plus(V a, V b) noexcept {
    return _mm256_add_ps(a, b);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V larger(V a, V b) noexcept {
    return _mm256_max_ps(a, b);
  }
  LASIUS_TARGET [[gnu::always_inline]] static V largest(V v) noexcept {
    v = _mm256_max_ps(v, _mm256_permute2f128_ps(v, v, 1));
    v = _mm256_max_ps(v, _mm256_shuffle_ps(v, v, 0x4e));
    return _mm256_max_ps(v, _mm256_shuffle_ps(v, v, 0xb1));
  }
  LASIUS_TARGET [[gnu::always_inline]] static std::uint32_t less(V a, V b) noexcept {
#if LASIUS_MASKS
    return _mm256_cmp_ps_mask(a, b, _CMP_LT_OQ);
#else
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
#endif
  }

 private:
#if !LASIUS_MASKS
  /// All bits of lane k set where bit k is.
  LASIUS_TARGET [[gnu::always_inline]] static V spread(std::uint32_t bits) noexcept {
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i on = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), bit);
    return _mm256_castsi256_ps(_mm256_cmpeq_epi32(on, bit));
  }
#endif
  template <int kBytes>
  LASIUS_TARGET [[gnu::always_inline]] static V shifted(V v) noexcept {
    return _mm256_castsi256_ps(_mm256_slli_si256(_mm256_castps_si256(v), kBytes));
  }
};

struct VectorOps : InTurnOps {
  /// As ScalarOps::roulette; rows of more than eight moves take several registers.
  template <int kLanes, bool kMixture, bool kFactor>
  LASIUS_TARGET [[gnu::always_inline]] static int roulette(const WalkWorld& world, const float* row,
                                                           std::uint32_t open,
                                                           std::uint32_t previous,
                                                           std::uint32_t random) noexcept {
    constexpr int kWidth = kLanes == 4 ? 4 : 8;
    constexpr int kParts = kLanes / kWidth;
    using R = Row<kWidth>;
    int rule = random < world.rule_start[kPheromoneRule] ? kGreedyRule : kCombinedRule;
    if constexpr (kMixture) {
      rule = (random >= world.rule_start[kPheromoneRule]) +
             (random >= world.rule_start[kDistanceRule]) +
             (random >= world.rule_start[kCombinedRule]);
    }
    typename R::V weight[kParts];
    std::uint32_t positive = 0;
    for (int part = 0; part < kParts; ++part) {
      const int k = part * kWidth;
      auto w = R::load(row + k);
      if constexpr (kFactor) w = R::times(w, R::load(world.factor[previous].data() + k));
      if constexpr (kMixture) {
        const auto distance = R::load(row + kLanes + k);
        const auto combined = R::times(w, distance);
        w = R::blend(w, distance, -(rule == kDistanceRule));
        w = R::blend(w, combined, -((rule == kCombinedRule) | (rule == kGreedyRule)));
      }
      weight[part] = R::only(w, open >> k);
      positive |= R::less(R::all(0), weight[part]) << k;
    }
    if (positive == 0) [[unlikely]]
      return -1;
    if (rule == kGreedyRule) {
      auto most = weight[0];
      for (int part = 1; part < kParts; ++part) most = R::larger(most, weight[part]);
      most = R::largest(most);
      std::uint32_t below = 0;
      for (int part = 0; part < kParts; ++part) {
        below |= R::less(weight[part], most) << (part * kWidth);
      }
      return __builtin_ctz(positive & ~below);
    }
    typename R::V sums[kParts];
    sums[0] = R::prefix(weight[0]);
    for (int part = 1; part < kParts; ++part) {
      sums[part] = R::plus(R::prefix(weight[part]), R::total(sums[part - 1]));
    }
    const auto rest = random - static_cast<std::uint32_t>(world.rule_start[rule]);
    const float share = static_cast<float>(rest) * world.rule_scale[rule];
    const auto threshold = R::times(R::all(share), R::total(sums[kParts - 1]));
    std::uint32_t hit = 0;
    for (int part = 0; part < kParts; ++part) {
      hit |= R::less(threshold, sums[part]) << (part * kWidth);
    }
    hit &= positive;
    if (hit == 0) [[unlikely]]
      return 31 - __builtin_clz(positive);
    return __builtin_ctz(hit);
  }

  /// As ScalarOps::race.
  template <int kLanes, bool kFactor>
  LASIUS_TARGET [[gnu::always_inline]] static int race(const WalkWorld& world, const float* row,
                                                       std::uint32_t open, std::uint32_t previous,
                                                       const float* at_weight_one) noexcept {
    constexpr int kWidth = kLanes == 4 ? 4 : 8;
    constexpr int kParts = kLanes / kWidth;
    using R = Row<kWidth>;
    typename R::V time[kParts];
    auto longest = R::all(0);
    std::uint32_t running = 0;
    for (int part = 0; part < kParts; ++part) {
      const int k = part * kWidth;
      auto mean = R::load(row + k);
      if constexpr (kFactor) mean = R::times(mean, R::load(world.factor[previous].data() + k));
      time[part] = R::only(R::times(R::load(at_weight_one + k), mean), open >> k);
      longest = R::larger(longest, time[part]);
      running |= R::less(R::all(0), time[part]) << k;
    }
    if (running == 0) [[unlikely]]
      return -1;
    longest = R::largest(longest);
    std::uint32_t below = 0;
    for (int part = 0; part < kParts; ++part) {
      below |= R::less(time[part], longest) << (part * kWidth);
    }
    return __builtin_ctz(running & ~below);
  }

  LASIUS_TARGET [[gnu::always_inline]] static std::uint32_t without_centre(
      std::uint32_t window) noexcept {
#if LASIUS_MASKS  // pext is quick on every CPU with these, not on the first ones with AVX2
    return _pext_u32(window, 0b111101111);
#else
    return (window & 15) | (window >> 5 & 15) << 4;
#endif
  }

  LASIUS_TARGET [[gnu::always_inline]] static std::uint32_t bits_at(std::uint64_t word,
                                                                    std::uint64_t mask) noexcept {
    return static_cast<std::uint32_t>(_pext_u64(word, mask));
  }
};

}  // namespace
}  // namespace lasius::kernels
