// The draws of eight ants at once, as ScalarOps has them; layouts as in abreast_avx512_lanes.h. The
// including file defines LASIUS_TARGET.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "kernels/walk/abreast_avx512_lanes.h"
#include "kernels/walk/race.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// Of rows of eight moves, or of four by two rules (kMixture). `closed` has bit k set where move k
/// is tabu, in halves, as `weight` is, which is consumed. A move is one an ant, its upper half
/// undefined; kStuck where every one is closed.
template <bool kMixture>
class AbreastDraw {
 public:
  static constexpr int kStuck = 16;

  /// As ScalarOps::roulette.
  LASIUS_TARGET [[gnu::always_inline]] static __m512i roulette(const WalkWorld& world,
                                                               __m512i random, __m512i closed,
                                                               __m512 (&weight)[4]) noexcept {
    const __mmask16 greedy = static_cast<__mmask16>(~reaches(world, kPheromoneRule, random));
    __m512i start = rule_start(world, kCombinedRule);
    __m512 scale = _mm512_set1_ps(world.rule_scale[kCombinedRule]);
    if constexpr (kMixture) {
      const auto before_combined =
          static_cast<__mmask16>(~reaches(world, kCombinedRule, random) & ~greedy);
      const auto by_pheromone =
          static_cast<__mmask16>(~reaches(world, kDistanceRule, random) & ~greedy);
      start = _mm512_mask_mov_epi32(start, before_combined, rule_start(world, kDistanceRule));
      start = _mm512_mask_mov_epi32(start, by_pheromone, rule_start(world, kPheromoneRule));
      scale = _mm512_mask_mov_ps(scale, before_combined,
                                 _mm512_set1_ps(world.rule_scale[kDistanceRule]));
      scale =
          _mm512_mask_mov_ps(scale, by_pheromone, _mm512_set1_ps(world.rule_scale[kPheromoneRule]));
      for (__m512& w : weight) {
        const __m512 pheromone = first_half(w), distance = second_half(w);
        w = _mm512_mask_mov_ps(_mm512_mul_ps(pheromone, distance), before_combined, distance);
        w = _mm512_mask_mov_ps(w, by_pheromone, pheromone);
      }
    }
    __mmask16 open[4];
    keep_open(closed, weight, open);

    // Prefix sums in the order of the reference.
    const __m512 pair = _mm512_add_ps(weight[1], weight[0]);
    __m512 sum[4] = {weight[0], pair, _mm512_add_ps(_mm512_add_ps(weight[2], weight[1]), weight[0]),
                     _mm512_add_ps(_mm512_add_ps(weight[3], weight[2]), pair)};
    __m512 total = sum[3];
    if constexpr (!kMixture) {
      const __m512 four = _mm512_maskz_shuffle_f32x4(0xf0f0, total, total, 0b10'10'00'00);
      for (__m512& s : sum) s = _mm512_add_ps(s, four);
      total = second_half(sum[3]);
    }
    const __m512 share = _mm512_mul_ps(_mm512_cvtepu32_ps(_mm512_sub_epi32(random, start)), scale);
    const __m512 threshold = _mm512_mul_ps(share, total);
    __mmask16 hit[4];
    for (int j = 0; j < 4; ++j) {
      hit[j] = _mm512_mask_cmp_ps_mask(open[j], threshold, sum[j], _CMP_LT_OQ);
    }
    __m512i move = first_of(hit);
    if (greedy != 0) {
      const __m512 most = largest(weight);
      __mmask16 best[4];
      for (int j = 0; j < 4; ++j) {
        best[j] = _mm512_mask_cmp_ps_mask(open[j], weight[j], most, _CMP_EQ_OQ);
      }
      move = _mm512_mask_mov_epi32(move, greedy, first_of(best));
    }
    const __mmask16 none = _mm512_cmp_ps_mask(total, _mm512_setzero_ps(), _CMP_EQ_OQ);
    move = _mm512_mask_mov_epi32(move, none, _mm512_set1_epi32(kStuck));
    const __mmask16 beyond = _mm512_cmpeq_epi32_mask(move, _mm512_set1_epi32(kBeyond));
    if (beyond != 0) [[unlikely]]
      move = _mm512_mask_mov_epi32(move, beyond, last_of(open));
    return one_an_ant(move);
  }
  /// As ScalarOps::race.
  LASIUS_TARGET [[gnu::always_inline]] static __m512i race(const __m512i (&numbers)[4],
                                                           __m512i closed,
                                                           __m512 (&mean)[4]) noexcept {
    __mmask16 open[4];
    keep_open(closed, mean, open);
    alignas(64) std::uint32_t number[4][16];
    alignas(64) float at_weight_one[4][16];
    for (int j = 0; j < 4; ++j) {
      _mm512_store_si512(number[j], numbers[j]);
      for (int i = 0; i < 16; ++i) at_weight_one[j][i] = minus_log2(number[j][i]);
    }
    __m512 time[4];
    for (int j = 0; j < 4; ++j) time[j] = _mm512_mul_ps(_mm512_load_ps(at_weight_one[j]), mean[j]);
    const __m512 longest = largest(time);
    __mmask16 last[4];
    for (int j = 0; j < 4; ++j) {
      last[j] = _mm512_mask_cmp_ps_mask(open[j], time[j], longest, _CMP_EQ_OQ);
    }
    const __mmask16 none = _mm512_cmp_ps_mask(longest, _mm512_setzero_ps(), _CMP_EQ_OQ);
    return one_an_ant(_mm512_mask_mov_epi32(first_of(last), none, _mm512_set1_epi32(kStuck)));
  }

 private:
  static constexpr int kBeyond = 32;  ///< instead of a move: rounding, at the end of the wheel

  /// Where move j (and j + 4) is not closed; sets the weights of the others to 0.
  LASIUS_TARGET [[gnu::always_inline]] static void keep_open(__m512i closed, __m512 (&weight)[4],
                                                             __mmask16 (&open)[4]) noexcept {
    for (int j = 0; j < 4; ++j) {
      const __mmask16 untouched =
          _mm512_testn_epi32_mask(closed, by_half<kMixture>(1 << j, 16 << j));
      open[j] = _mm512_mask_cmp_ps_mask(untouched, weight[j], _mm512_setzero_ps(), _CMP_GT_OQ);
      weight[j] = _mm512_maskz_mov_ps(open[j], weight[j]);
    }
  }
  /// The first move of those set, kBeyond if none is; in halves.
  LASIUS_TARGET [[gnu::always_inline]] static __m512i first_of(const __mmask16 (&set)[4]) noexcept {
    __m512i move = _mm512_set1_epi32(kBeyond);
    for (int j = 3; j >= 0; --j)
      move = _mm512_mask_mov_epi32(move, set[j], by_half<kMixture>(j, j + 4));
    if constexpr (kMixture) return move;
    return _mm512_min_epu32(move, _mm512_shuffle_i32x4(move, move, 0b10'11'00'01));
  }
  /// The largest of the moves of each ant, in both halves.
  LASIUS_TARGET [[gnu::always_inline]] static __m512 largest(const __m512 (&v)[4]) noexcept {
    const __m512 most = _mm512_max_ps(_mm512_max_ps(v[0], v[1]), _mm512_max_ps(v[2], v[3]));
    if constexpr (kMixture) return most;
    return _mm512_max_ps(most, _mm512_shuffle_f32x4(most, most, 0b10'11'00'01));
  }
  LASIUS_TARGET static __m512i last_of(const __mmask16 (&set)[4]) noexcept {
    __m512i move = _mm512_setzero_si512();
    for (int j = 0; j < 4; ++j)
      move = _mm512_mask_mov_epi32(move, set[j], by_half<kMixture>(j, j + 4));
    return _mm512_max_epu32(move, _mm512_shuffle_i32x4(move, move, 0b10'11'00'01));
  }

  LASIUS_TARGET [[gnu::always_inline]] static __m512i rule_start(const WalkWorld& world,
                                                                 Rule rule) noexcept {
    return _mm512_set1_epi32(static_cast<int>(world.rule_start[rule]));
  }
  /// Where the word is not before the rule's share of the wheel.
  LASIUS_TARGET [[gnu::always_inline]] static __mmask16 reaches(const WalkWorld& world, Rule rule,
                                                                __m512i random) noexcept {
    if (world.rule_start[rule] >> 32 != 0) return 0;  // behind the wheel's end
    return _mm512_cmpge_epu32_mask(random, rule_start(world, rule));
  }
};

}  // namespace
}  // namespace lasius::kernels
