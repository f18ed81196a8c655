// The draws of eight ants at once, as ScalarOps has them; layouts as in avx2_vectors.h.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "kernels/walk/avx2_vectors.h"
#include "kernels/walk/lockstep_planes.h"
#include "kernels/walk/race.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// Draws from rows of four or eight moves. With kMixture rows hold weights of two rules: pheromone,
/// then distance.
template <int kMoves, bool kMixture>
class LockstepDraw {
 public:
  static constexpr int kWeights = kMixture ? 2 * kMoves : kMoves;  ///< of a row

  struct Choice {
    __m256i move;   ///< undefined where stuck
    __m256i stuck;  ///< every move is closed
  };

  /// As ScalarOps::roulette. Consumes `weight`.
  LASIUS_AVX2 [[gnu::always_inline]] static Choice roulette(const WalkWorld& world, __m256i random,
                                                            const LockstepPlanes::Entered& entered,
                                                            __m256 (&weight)[kWeights]) noexcept {
    const __m256i reached = reaches(world, kPheromoneRule, random);
    const __m256i greedy = _mm256_andnot_si256(reached, all(~0u));
    __m256i start = rule_start(world, kCombinedRule);
    __m256 scale = _mm256_set1_ps(world.rule_scale[kCombinedRule]);
    if constexpr (kMixture) {
      const __m256i before_combined =
          _mm256_andnot_si256(reaches(world, kCombinedRule, random), reached);
      const __m256i by_pheromone =
          _mm256_andnot_si256(reaches(world, kDistanceRule, random), reached);
      start = choose(start, rule_start(world, kDistanceRule), before_combined);
      start = choose(start, rule_start(world, kPheromoneRule), by_pheromone);
      scale = choose(scale, _mm256_set1_ps(world.rule_scale[kDistanceRule]), before_combined);
      scale = choose(scale, _mm256_set1_ps(world.rule_scale[kPheromoneRule]), by_pheromone);
      for (int k = 0; k < kMoves; ++k) {
        const __m256 pheromone = weight[k], distance = weight[k + kMoves];
        const __m256 chosen = choose(_mm256_mul_ps(pheromone, distance), distance, before_combined);
        weight[k] = choose(chosen, pheromone, by_pheromone);
      }
    }
    keep_open(entered, weight);

    // Prefix sums in the order of the reference.
    __m256 sum[kMoves];
    for (int k = 0; k < kMoves; k += 4) {
      const __m256* w = weight + k;
      sum[k] = w[0];
      sum[k + 1] = _mm256_add_ps(w[1], w[0]);
      sum[k + 2] = _mm256_add_ps(_mm256_add_ps(w[2], w[1]), w[0]);
      sum[k + 3] = _mm256_add_ps(_mm256_add_ps(w[3], w[2]), sum[k + 1]);
    }
    for (int k = 4; k < kMoves; ++k) sum[k] = _mm256_add_ps(sum[k], sum[3]);
    const __m256 total = sum[kMoves - 1], zero = _mm256_setzero_ps();
    const __m256 share = _mm256_mul_ps(to_float(_mm256_sub_epi32(random, start)), scale);
    const __m256 threshold = _mm256_mul_ps(share, total);

    Choice choice{all(kUnclear), equal(total, zero)};
    for (int k = kMoves - 1; k >= 0; --k) {
      __m256i move = all(k);
      // The sums of these two are added up in another order than the one before, and so may pass
      // the threshold by rounding though their own weight is 0.
      if (k % 4 == 3) move = choose(move, all(kUnclear), equal(weight[k], zero));
      choice.move = choose(choice.move, move, less(threshold, sum[k]));
    }
    if (any(greedy)) choice.move = choose(choice.move, first_largest(weight), greedy);
    const __m256i unclear =
        _mm256_andnot_si256(choice.stuck, _mm256_cmpeq_epi32(choice.move, all(kUnclear)));
    if (any(unclear)) [[unlikely]]
      choice.move = choose(choice.move, spin(threshold, weight, sum), unclear);
    return choice;
  }

  /// As ScalarOps::race. Consumes `mean`.
  LASIUS_AVX2 [[gnu::always_inline]] static Choice race(const __m256i (&numbers)[kMoves],
                                                        const LockstepPlanes::Entered& entered,
                                                        __m256 (&mean)[kMoves]) noexcept {
    keep_open(entered, mean);
    alignas(32) PerAnt number[kMoves];
    alignas(32) float at_weight_one[kMoves][8];
    for (int k = 0; k < kMoves; ++k) {
      store(number[k], numbers[k]);
      for (int i = 0; i < 8; ++i) at_weight_one[k][i] = minus_log2(number[k][i]);
    }
    __m256 longest = _mm256_setzero_ps();
    __m256i move = all(0);
    for (int k = 0; k < kMoves; ++k) {
      const __m256 time = _mm256_mul_ps(_mm256_load_ps(at_weight_one[k]), mean[k]);
      move = choose(move, all(k), less(longest, time));
      longest = _mm256_max_ps(longest, time);
    }
    return {move, equal(longest, _mm256_setzero_ps())};
  }

 private:
  static constexpr int kUnclear = 32;  ///< instead of a move

  /// Sets the weights of closed moves to 0.
  LASIUS_AVX2 [[gnu::always_inline]] static void keep_open(const LockstepPlanes::Entered& entered,
                                                           __m256 (&weight)[kWeights]) noexcept {
    const auto& [above, beside, below] = entered;
    if constexpr (kMoves == 4) {
      weight[0] = unless(above, 2, weight[0]);
      weight[1] = unless(beside, 1, weight[1]);
      weight[2] = unless(beside, 4, weight[2]);
      weight[3] = unless(below, 2, weight[3]);
    } else {
      for (int k = 0; k < 3; ++k) {
        weight[k] = unless(above, 1 << k, weight[k]);
        weight[k + 5] = unless(below, 1 << k, weight[k + 5]);
      }
      weight[3] = unless(beside, 1, weight[3]);
      weight[4] = unless(beside, 4, weight[4]);
    }
  }
  /// The weight, 0 where the bit is set.
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 unless(__m256i entered, int bit,
                                                          __m256 weight) noexcept {
    const __m256i open = _mm256_andnot_si256(entered, all(bit));
    return _mm256_castsi256_ps(_mm256_sign_epi32(_mm256_castps_si256(weight), open));
  }

  /// The wheel as the reference spins it: the first move of those open whose sum passes the
  /// threshold; behind its end, by rounding, the last one.
  LASIUS_AVX2 static __m256i spin(__m256 threshold, const __m256 (&weight)[kWeights],
                                  const __m256 (&sum)[kMoves]) noexcept {
    __m256i last = all(0), first = all(kUnclear);
    for (int k = 0; k < kMoves; ++k) {
      const __m256i open = less(_mm256_setzero_ps(), weight[k]);
      const __m256i hit = _mm256_and_si256(open, less(threshold, sum[k]));
      last = choose(last, all(k), open);
      first = choose(first, _mm256_min_epu32(first, all(k)), hit);
    }
    return choose(first, last, _mm256_cmpeq_epi32(first, all(kUnclear)));
  }
  LASIUS_AVX2 [[gnu::always_inline]] static __m256i first_largest(
      const __m256 (&weight)[kWeights]) noexcept {
    __m256 most = weight[0];
    for (int k = 1; k < kMoves; ++k) most = _mm256_max_ps(most, weight[k]);
    __m256i move = all(0);
    for (int k = kMoves - 1; k >= 0; --k) move = choose(move, all(k), equal(weight[k], most));
    return move;
  }

  LASIUS_AVX2 [[gnu::always_inline]] static __m256i rule_start(const WalkWorld& world,
                                                               Rule rule) noexcept {
    return all(static_cast<std::uint32_t>(world.rule_start[rule]));
  }
  /// Where the word is not before the rule's share of the wheel.
  LASIUS_AVX2 [[gnu::always_inline]] static __m256i reaches(const WalkWorld& world, Rule rule,
                                                            __m256i random) noexcept {
    if (world.rule_start[rule] >> 32 != 0) return all(0);  // behind the wheel's end
    return _mm256_cmpeq_epi32(_mm256_max_epu32(random, rule_start(world, rule)), random);
  }
  /// Of unsigned numbers, rounded once: the halves are mantissas, 2^39 + 2^16 high and 2^23 + low.
  LASIUS_AVX2 [[gnu::always_inline]] static __m256 to_float(__m256i v) noexcept {
    const __m256i high = _mm256_blend_epi16(_mm256_srli_epi32(v, 16), all(0x53000000), 0xaa);
    const __m256i low = _mm256_blend_epi16(v, all(0x4b000000), 0xaa);
    const __m256 exact = _mm256_sub_ps(_mm256_castsi256_ps(high), _mm256_set1_ps(0x1.0001p39f));
    return _mm256_add_ps(exact, _mm256_castsi256_ps(low));
  }
};

}  // namespace
}  // namespace lasius::kernels
