// One step of eight ants in lock-step with AVX2, an ant a lane; layouts as in avx2_vectors.h.
#pragma once

#include <immintrin.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "kernels/walk/avx2_vectors.h"
#include "kernels/walk/lockstep_ants.h"
#include "kernels/walk/lockstep_draw.h"
#include "kernels/walk/lockstep_planes.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

LASIUS_AVX2 [[gnu::always_inline]] inline __m128i four_bytes(
    const std::uint8_t* const* at) noexcept {
  const __m128i one = _mm_cvtsi32_si128(*at[0]);
  const __m128i two = _mm_insert_epi8(one, *at[1], 1);
  return _mm_insert_epi8(_mm_insert_epi8(two, *at[2], 2), *at[3], 3);
}

/// Up to eight ants with rows of four or eight moves. A step is the phases below in order.
template <int kMoves, bool kMixture, bool kFactor, Draw kDraw>
class LockstepGroup {
  using DrawOf = LockstepDraw<kMoves, kMixture>;
  static constexpr std::uint32_t kSet = ~std::uint32_t{0};

 public:
  using Ants = LockstepAnts<kMoves, kFactor, kDraw>;
  static constexpr int kWorthwhile = 4;  ///< fewer are as fast interleaved, one by one

  using Words = __m256i[4];
  static constexpr int kWeights = DrawOf::kWeights;
  using Weights = __m256[kWeights];
  struct Step {
    typename DrawOf::Choice choice;
    __m256i to;
    __m256i walks;
    __m256i on;  ///< of those that walk: not back
  };

  /// Takes over ants under way, whose rows and words are found.
  LASIUS_AVX2 LockstepGroup(const WalkWorld& world, std::span<WalkSlot* const> slots) noexcept
      : planes_(slots.empty() ? 0 : slots[0]->visited.rows) {
    if (slots.empty()) return;
    no_return_.fill(world.backtrack ? 0 : kSet);
    for (int i = 0; i < Ants::kAnts; ++i) {
      if (i < static_cast<int>(slots.size())) {
        take(i, *slots[i]);
      } else {
        leave_empty(i, *slots[0]);
      }
    }
    planes_.find(load(ants_.at));
    see();
  }

  /// Bit i: ant i walks.
  LASIUS_AVX2 unsigned walking() const noexcept { return bits(load(walking_)); }
  /// An ant that walks; the others were handed back when they ended.
  void hand_back(int i) const noexcept { ants_.hand_back(i, planes_.word(i)); }

  /// The next block of every ant, a word in each register.
  LASIUS_AVX2 [[gnu::always_inline]] void draw_words(const WalkWorld& world,
                                                     Words& words) noexcept {
    prefetch_ends();
    const __m256i block = load(ants_.block);
    philox(world, block, load(ants_.number), words);
    store(ants_.block, _mm256_add_epi32(block, all(1)));
  }

  /// The ants' rows, times the factors: weight k of all.
  LASIUS_AVX2 [[gnu::always_inline]] void rows(const WalkWorld& world,
                                               Weights& weight) const noexcept {
    for (int k = 0; k < kWeights; k += 4) {
      __m256 four[4];  // weights of ant i, and of ant i + 4
      for (int i = 0; i < 4; ++i) {
        four[i] = two_at(ants_.row[i] + k, ants_.row[i + 4] + k);
        if (!kFactor || k >= kMoves) continue;
        const auto &low = world.factor[ants_.last[i]], &high = world.factor[ants_.last[i + 4]];
        four[i] = _mm256_mul_ps(four[i], two_at(low.data() + k, high.data() + k));
      }
      const __m256 ab = _mm256_unpacklo_ps(four[0], four[1]);
      const __m256 cd = _mm256_unpacklo_ps(four[2], four[3]);
      const __m256 ab2 = _mm256_unpackhi_ps(four[0], four[1]);
      const __m256 cd2 = _mm256_unpackhi_ps(four[2], four[3]);
      weight[k] = _mm256_shuffle_ps(ab, cd, 0x44);
      weight[k + 1] = _mm256_shuffle_ps(ab, cd, 0xee);
      weight[k + 2] = _mm256_shuffle_ps(ab2, cd2, 0x44);
      weight[k + 3] = _mm256_shuffle_ps(ab2, cd2, 0xee);
    }
  }

  LASIUS_AVX2 [[gnu::always_inline]] void draw(const WalkWorld& world, const Words& words,
                                               int round, Weights& weight,
                                               Step& step) const noexcept {
    const LockstepPlanes::Entered entered{load(above_), load(beside_), load(below_)};
    if constexpr (kDraw == Draw::discard) {
      __m256i number[kMoves];
      for (int k = 0; k < kMoves; ++k) {
        const int n = round % Ants::kStepsABlock * kMoves + k;
        number[k] = n < 4 ? words[n] : turned(words[n - 4]);
      }
      step.choice = DrawOf::race(number, entered, weight);
    } else {
      step.choice = DrawOf::roulette(world, words[round], entered, weight);
    }
  }

  /// On by the move drawn, or back by the last one; the tours follow.
  LASIUS_AVX2 [[gnu::always_inline]] void go(const WalkWorld& world, Step& step,
                                             int round) noexcept {
    const __m256i last = load(ants_.last);
    const __m256i stuck = _mm256_and_si256(step.choice.stuck, load(walking_));
    const __m256i at_start = _mm256_cmpeq_epi32(last, all(kMaxMoves));
    const __m256i lost = _mm256_and_si256(stuck, _mm256_or_si256(at_start, load(no_return_)));
    if (any(lost)) [[unlikely]]
      end(bits(lost), WalkState::lost, round);
    step.walks = load(walking_);
    const __m256i back = _mm256_and_si256(stuck, step.walks);
    step.on = _mm256_andnot_si256(stuck, step.walks);

    const __m256i move = choose(step.choice.move, last, back), from = load(ants_.at);
    const __m256i deltas = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(world.delta.data()));
    const __m256i ahead = _mm256_permutevar8x32_epi32(deltas, move);
    const __m256i by = _mm256_sub_epi32(_mm256_xor_si256(ahead, back), back);  // negative if back
    step.to = _mm256_add_epi32(from, _mm256_and_si256(by, step.walks));
    store(ants_.at, step.to);

    const Wide top = load_wide(ants_.top), back_wide = widen_mask(back);  // as numbers: -1
    const Wide kept = plus(top, back_wide);  // the ends of the tours, less what is taken back
    static constexpr std::uint8_t kNoMove = kMaxMoves;
    alignas(32) PerAntWide<const std::uint8_t*> before;
    store_wide(before,
               choose(minus(kept, all_wide(1)), all_wide(std::bit_cast<std::int64_t>(&kNoMove)),
                      equal(kept, load_wide(ants_.base))));

    // An ant that goes on writes its move, and three bytes behind it that later moves overwrite;
    // one that goes back, the cell it leaves.
    const Wide dead = load_wide(ants_.dead);
    alignas(32) PerAntWide<void*> places;
    alignas(32) PerAnt written;
    store_wide(places, choose(top, dead, back_wide));
    store(written, choose(move, from, back));
    // The last move of those that went back; before the stores, so that no load waits for them.
    const __m128i now_last = _mm_unpacklo_epi8(four_bytes(&before[0]), four_bytes(&before[4]));
    store(ants_.last, choose(_mm256_cvtepu8_epi32(now_last), move, step.on));
    for (int i = 0; i < Ants::kAnts; ++i) {
      std::memcpy(places[place(i)], &written[i], sizeof(PackedCell));
    }
    store_wide(ants_.top, minus(kept, widen_mask(step.on)));
    store_wide(ants_.dead, minus(dead, {_mm256_slli_epi64(back_wide.even, 2),
                                        _mm256_slli_epi64(back_wide.odd, 2)}));
  }

  /// Finds what belongs to the cells. Without a branch on whether an ant leaves its tile: of eight,
  /// one often does.
  LASIUS_AVX2 [[gnu::always_inline]] void find(const WalkWorld& world, const Step& step) {
    // Sums of the products of the halves of a cell: x and y.
    alignas(32) PerAnt tile, row_byte;
    store(tile,
          _mm256_madd_epi16(_mm256_srli_epi16(step.to, kTileShift), all(pack(1, world.tiles_x))));
    constexpr int kRowBytes = kWeights * sizeof(float);
    const __m256i in_tile = _mm256_and_si256(step.to, all(pack(kTileSide - 1, kTileSide - 1)));
    store(row_byte, _mm256_madd_epi16(in_tile, all(pack(kRowBytes, kTileSide * kRowBytes))));
    if (!find_rows(world, tile, row_byte)) [[unlikely]] {
      for (const std::uint32_t t : tile) {
        if (__atomic_load_n(world.tiles + t, __ATOMIC_ACQUIRE) != nullptr) continue;
        world.make_tile(world.context, static_cast<int>(t));
      }
      find_rows(world, tile, row_byte);
    }
    planes_.find(step.to);
  }

  /// Looks which moves from the new cells are closed and marks these as entered; ends the walks
  /// that have arrived.
  LASIUS_AVX2 [[gnu::always_inline]] void enter(const WalkWorld& world, const Step& step,
                                                int round) noexcept {
    see();  // before it is marked, so that no load waits for the stores
    planes_.mark(step.walks, step.to);
    const __m256i arrived = _mm256_and_si256(_mm256_cmpeq_epi32(step.to, all(world.goal)), step.on);
    if (any(arrived)) [[unlikely]]
      end(bits(arrived), WalkState::arrived, round);
  }

 private:
  /// Asks for the lines behind those in which tours end: stores that miss hold up those after them.
  [[gnu::always_inline]] void prefetch_ends() const noexcept {
    constexpr int kLine = 64;
    for (const std::uint8_t* top : ants_.top) __builtin_prefetch(top + kLine, 1);
    for (const PackedCell* dead : ants_.dead)
      __builtin_prefetch(dead + kLine / sizeof(PackedCell), 1);
  }

  LASIUS_AVX2 [[gnu::always_inline]] static __m256 two_at(const float* low,
                                                          const float* high) noexcept {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1);
  }

  /// False where a tile is still to be made.
  LASIUS_AVX2 [[gnu::always_inline]] bool find_rows(const WalkWorld& world, const PerAnt& tile,
                                                    const PerAnt& row_byte) noexcept {
    std::uintptr_t missing = 0;
#pragma GCC unroll 8
    for (int i = 0; i < Ants::kAnts; ++i) {
      float* const rows = __atomic_load_n(world.tiles + tile[i], __ATOMIC_ACQUIRE);
      const auto address = std::bit_cast<std::uintptr_t>(rows);
      missing |= address - 1;  // the upper bit is set of 0 - 1 alone
      ants_.row[i] = std::bit_cast<const float*>(address + row_byte[i]);
      __builtin_prefetch(ants_.row[i]);
    }
    return std::bit_cast<std::intptr_t>(missing) >= 0;
  }

  LASIUS_AVX2 [[gnu::always_inline]] void see() noexcept {
    const auto entered = planes_.around(load(ants_.at));
    store(above_, entered.above);
    store(beside_, entered.beside);
    store(below_, entered.below);
  }

  void take(int i, WalkSlot& slot) noexcept {
    planes_.take(i, slot);
    ants_.take(i, slot);
    walking_[i] = kSet;
  }
  /// A lane without an ant stays at the cell of another one, and its steps write nothing that is
  /// read. So does a lane whose ant has ended, where that one did.
  void leave_empty(int i, const WalkSlot& other) noexcept {
    planes_.take(i, other);
    ants_.leave_empty(i, other.at, other.row);
  }
  /// Hands back the ants that have ended, by bits; `round` counts from 0.
  void end(unsigned which, WalkState state, int round) noexcept {
    for (; which != 0; which &= which - 1) {
      const int i = __builtin_ctz(which);
      ants_.end(i, planes_.word(i), state, round);
      walking_[i] = 0;
    }
  }

  Ants ants_;
  LockstepPlanes planes_;
  alignas(32) PerAnt walking_{};    ///< a mask
  alignas(32) PerAnt no_return_{};  ///< a mask
  alignas(32) PerAnt above_{};      ///< LockstepPlanes::Entered
  alignas(32) PerAnt beside_{};
  alignas(32) PerAnt below_{};
};

}  // namespace
}  // namespace lasius::kernels
