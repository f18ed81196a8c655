// One step of eight ants abreast with AVX2, an ant a lane of 32 bits; layouts as in
// abreast_avx2_lanes.h. The including file defines LASIUS_TARGET.
#pragma once

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "kernels/abreast_avx2_draw.h"
#include "kernels/abreast_avx2_lanes.h"
#include "kernels/abreast_avx2_planes.h"
#include "kernels/walk.h"

namespace lasius::kernels {
namespace {

/// Is there one of this shape? Of four or eight moves.
constexpr bool goes_abreast(WalkShape shape) noexcept { return shape.lanes <= 8; }

/// Up to eight ants.
template <int kMoves, bool kMixture, bool kFactor, Draw kDraw>
class Abreast {
 public:
  static constexpr int kAnts = 8;
  static constexpr int kWorthwhile = 4;  ///< fewer walk as fast one by one
  /// Steps between two looks at how many still walk; a roulette reads a Philox block in them.
  static constexpr int kRounds = 4;

  /// Takes over ants under way, whose rows and words are found.
  LASIUS_TARGET Abreast(const WalkWorld& world, std::span<WalkSlot* const> slots) noexcept
      : planes_(slots.empty() ? 0 : slots[0]->visited.rows) {
    if (slots.empty()) return;
    no_return_.fill(world.backtrack ? 0 : kSet);
    for (int i = 0; i < kAnts; ++i) {
      if (i < static_cast<int>(slots.size())) {
        take(i, *slots[i]);
      } else {
        rest(i, *slots[0]);
      }
    }
    planes_.find(load(at_));
    see();
  }

  LASIUS_TARGET int walking() const noexcept { return __builtin_popcount(bits(load(walking_))); }

  /// kRounds steps of every ant of the groups.
  template <int kGroups>
  LASIUS_TARGET static void advance(const WalkWorld& world, Abreast* const (&groups)[kGroups]) {
    __m256i words[kGroups][kWords];
    for (Abreast* group : groups) group->prefetch_ends();
    for (int round = 0; round < kRounds; ++round) {
      if (kDraw == Draw::discard || round == 0) {
        for (int g = 0; g < kGroups; ++g) groups[g]->draw_words(world, words[g]);
      }
      // Phase by phase, so that the groups' chains are in flight together.
      Step steps[kGroups];
#pragma GCC unroll 2
      for (int g = 0; g < kGroups; ++g) groups[g]->draw(world, words[g], round, steps[g]);
#pragma GCC unroll 2
      for (int g = 0; g < kGroups; ++g) groups[g]->go(world, steps[g], round);
#pragma GCC unroll 2
      for (int g = 0; g < kGroups; ++g) groups[g]->find(world, steps[g]);
#pragma GCC unroll 2
      for (int g = 0; g < kGroups; ++g) groups[g]->enter(world, steps[g], round);
    }
  }

  /// Hands back the ants that still walk; the others were when they ended.
  void hand_back() noexcept {
    for (int i = 0; i < kAnts; ++i) {
      if (walking_[i] != 0) hand_back(i, std::uint64_t{block_[i]} * kBlock);
    }
  }

 private:
  using DrawOf = AbreastDraw<kMoves, kMixture>;
  static constexpr int kWeights = DrawOf::kWeights;
  static constexpr int kBlock = 4;  ///< words of a Philox block
  static constexpr int kWords = kDraw == Draw::discard ? kMoves : kBlock;
  static constexpr std::uint32_t kSet = ~std::uint32_t{0};

  struct Step {
    typename DrawOf::Choice choice;
    __m256i to;
    __m256i walks;
    __m256i on;  ///< of those that walk: not back
  };

  /// Asks for the lines behind those in which tours end: stores that miss hold up those after them.
  [[gnu::always_inline]] void prefetch_ends() const noexcept {
    constexpr int kLine = 64;
    for (const std::uint8_t* top : top_) __builtin_prefetch(top + kLine, 1);
    for (const PackedCell* dead : dead_) __builtin_prefetch(dead + kLine / sizeof(PackedCell), 1);
  }

  // --- Random words

  /// The next word of every ant in each of four registers; for a race the words of its moves.
  /// As `refill`.
  LASIUS_TARGET [[gnu::always_inline]] void draw_words(const WalkWorld& world,
                                                       __m256i (&words)[kWords]) noexcept {
    for (int w = 0; w < kWords; w += kBlock) {
      const __m256i block = load(block_);
      __m256i four[kBlock];
      philox(world, block, load(ant_), four);
      for (int j = 0; j < kBlock; ++j) words[w + j] = four[j];
      store(block_, _mm256_add_epi32(block, all(1)));
    }
  }

  // --- The draw

  LASIUS_TARGET [[gnu::always_inline]] void draw(const WalkWorld& world,
                                                 const __m256i (&words)[kWords], int round,
                                                 Step& step) const noexcept {
    __m256 weight[kWeights];
    rows(world, weight);
    const AbreastPlanes::Entered entered{load(above_), load(beside_), load(below_)};
    if constexpr (kDraw == Draw::discard) {
      step.choice = DrawOf::race(words, entered, weight);
    } else {
      step.choice = DrawOf::roulette(world, words[round], entered, weight);
    }
  }
  /// The ants' rows, times the factors: weight k of all.
  LASIUS_TARGET [[gnu::always_inline]] void rows(const WalkWorld& world,
                                                 __m256 (&weight)[kWeights]) const noexcept {
    for (int k = 0; k < kWeights; k += 4) {
      __m256 four[4];  // weights of ant i, and of ant i + 4
      for (int i = 0; i < 4; ++i) {
        four[i] = two_at(row_[i] + k, row_[i + 4] + k);
        if (!kFactor || k >= kMoves) continue;
        const auto &low = world.factor[last_[i]], &high = world.factor[last_[i + 4]];
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
  LASIUS_TARGET [[gnu::always_inline]] static __m256 two_at(const float* low,
                                                            const float* high) noexcept {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1);
  }

  // --- The step

  /// On by the move drawn, or back by the last one; the tours follow.
  LASIUS_TARGET [[gnu::always_inline]] void go(const WalkWorld& world, Step& step,
                                               int round) noexcept {
    const __m256i last = load(last_);
    const __m256i stuck = _mm256_and_si256(step.choice.stuck, load(walking_));
    const __m256i at_start = _mm256_cmpeq_epi32(last, all(kMaxMoves));
    const __m256i lost = _mm256_and_si256(stuck, _mm256_or_si256(at_start, load(no_return_)));
    if (any(lost)) [[unlikely]]
      end(bits(lost), WalkState::lost, round);
    step.walks = load(walking_);
    const __m256i back = _mm256_and_si256(stuck, step.walks);
    step.on = _mm256_andnot_si256(stuck, step.walks);

    const __m256i move = choose(step.choice.move, last, back), from = load(at_);
    const __m256i deltas = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(world.delta.data()));
    const __m256i ahead = _mm256_permutevar8x32_epi32(deltas, move);
    const __m256i by = _mm256_sub_epi32(_mm256_xor_si256(ahead, back), back);  // negative if back
    step.to = _mm256_add_epi32(from, _mm256_and_si256(by, step.walks));
    store(at_, step.to);

    const Wide top = load_wide(top_), back_wide = widen_mask(back);  // as numbers: -1
    const Wide kept = plus(top, back_wide);  // the ends of the tours, less what is taken back
    static constexpr std::uint8_t kNoMove = kMaxMoves;
    alignas(32) PerAntWide<const std::uint8_t*> before;
    store_wide(before,
               choose(minus(kept, all_wide(1)), all_wide(std::bit_cast<std::int64_t>(&kNoMove)),
                      equal(kept, load_wide(base_))));

    // Who goes on writes its move, and three bytes that do not count yet; who goes back the cell it
    // leaves.
    const Wide dead = load_wide(dead_);
    alignas(32) PerAntWide<void*> places;
    alignas(32) PerAnt written;
    store_wide(places, choose(top, dead, back_wide));
    store(written, choose(move, from, back));
    // The last move of those that went back; before the stores, so that no load waits for them.
    const __m128i now_last = _mm_unpacklo_epi8(four_bytes(&before[0]), four_bytes(&before[4]));
    store(last_, choose(_mm256_cvtepu8_epi32(now_last), move, step.on));
    for (int i = 0; i < kAnts; ++i) {
      std::memcpy(places[place(i)], &written[i], sizeof(PackedCell));
    }
    store_wide(top_, minus(kept, widen_mask(step.on)));
    store_wide(dead_, minus(dead, {_mm256_slli_epi64(back_wide.even, 2),
                                   _mm256_slli_epi64(back_wide.odd, 2)}));
  }

  LASIUS_TARGET [[gnu::always_inline]] static __m128i four_bytes(
      const std::uint8_t* const* at) noexcept {
    const __m128i one = _mm_cvtsi32_si128(*at[0]);
    const __m128i two = _mm_insert_epi8(one, *at[1], 1);
    return _mm_insert_epi8(_mm_insert_epi8(two, *at[2], 2), *at[3], 3);
  }

  /// Finds what belongs to the cells. Without a branch on whether an ant leaves its tile: of eight,
  /// one often does.
  LASIUS_TARGET [[gnu::always_inline]] void find(const WalkWorld& world, const Step& step) {
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
  /// False where a tile is still to be made.
  LASIUS_TARGET [[gnu::always_inline]] bool find_rows(const WalkWorld& world, const PerAnt& tile,
                                                      const PerAnt& row_byte) noexcept {
    std::uintptr_t missing = 0;
#pragma GCC unroll 8
    for (int i = 0; i < kAnts; ++i) {
      float* const rows = __atomic_load_n(world.tiles + tile[i], __ATOMIC_ACQUIRE);
      const auto address = std::bit_cast<std::uintptr_t>(rows);
      missing |= address - 1;  // the upper bit is set of 0 - 1 alone
      row_[i] = std::bit_cast<const float*>(address + row_byte[i]);
      __builtin_prefetch(row_[i]);
    }
    return std::bit_cast<std::intptr_t>(missing) >= 0;
  }

  /// Sees what is closed around the new cells and marks them as entered; ends who has arrived.
  LASIUS_TARGET [[gnu::always_inline]] void enter(const WalkWorld& world, const Step& step,
                                                  int round) noexcept {
    see();  // before it is marked, so that no load waits for the stores
    planes_.mark(step.walks, step.to);
    const __m256i arrived = _mm256_and_si256(_mm256_cmpeq_epi32(step.to, all(world.goal)), step.on);
    if (any(arrived)) [[unlikely]]
      end(bits(arrived), WalkState::arrived, round);
  }
  LASIUS_TARGET [[gnu::always_inline]] void see() noexcept {
    const auto entered = planes_.around(load(at_));
    store(above_, entered.above);
    store(beside_, entered.beside);
    store(below_, entered.below);
  }

  // --- Coming and going

  void take(int i, WalkSlot& slot) noexcept {
    slots_[i] = &slot;
    walking_[i] = kSet;
    planes_.take(i, slot);
    at_[i] = slot.at;
    row_[i] = slot.row;
    base_[place(i)] = slot.moves;
    top_[place(i)] = slot.moves + slot.move_count;
    last_[i] = slot.move_count > 0 ? slot.moves[slot.move_count - 1] : std::uint32_t{kMaxMoves};
    dead_[place(i)] = slot.dead + slot.dead_count;
    block_[i] = static_cast<std::uint32_t>(slot.words_used() / kBlock);
    ant_[i] = slot.ant;
  }
  /// A lane without an ant stands where another one does, with a tour of its own. So does one whose
  /// ant has ended: it stays, and writes nothing that counts.
  void rest(int i, const WalkSlot& stand_in) noexcept {
    planes_.take(i, stand_in);
    at_[i] = stand_in.at;
    row_[i] = stand_in.row;
    base_[place(i)] = top_[place(i)] = reinterpret_cast<std::uint8_t*>(&spare_);
    last_[i] = kMaxMoves;
    dead_[place(i)] = &spare_;
  }
  /// Who has ended, `round` counted from 0.
  void end(unsigned which, WalkState state, int round) noexcept {
    const int unread = kDraw == Draw::discard ? 0 : kRounds - 1 - round;
    for (; which != 0; which &= which - 1) {
      const int i = __builtin_ctz(which);
      hand_back(i, std::uint64_t{block_[i]} * kBlock - static_cast<unsigned>(unread));
      slots_[i]->state = state;
      walking_[i] = 0;
    }
  }
  void hand_back(int i, std::uint64_t words) noexcept {
    WalkSlot& slot = *slots_[i];
    slot.at = at_[i];
    slot.row = row_[i];
    slot.word = planes_.word(i);
    slot.move_count = top_[place(i)] - base_[place(i)];
    slot.dead_count = dead_[place(i)] - slot.dead;
    if (kFactor) slot.previous = last_[i];
    slot.random_block = static_cast<std::uint32_t>((words + kBlock - 1) / kBlock);
    slot.random_used = WalkSlot::kRandomWords - static_cast<std::uint32_t>(-words % kBlock);
  }

  alignas(32) PerAnt at_{};
  alignas(32) PerAnt walking_{};    ///< a mask
  alignas(32) PerAnt no_return_{};  ///< a mask
  alignas(32) PerAnt above_{};      ///< AbreastPlanes::Entered
  alignas(32) PerAnt beside_{};
  alignas(32) PerAnt below_{};
  alignas(32) PerAnt last_{};   ///< moves; kMaxMoves at the start
  alignas(32) PerAnt block_{};  ///< next Philox counters
  alignas(32) PerAnt ant_{};
  alignas(32) PerAntWide<std::uint8_t*> base_{};  ///< of the tours
  alignas(32) PerAntWide<std::uint8_t*> top_{};   ///< their ends
  alignas(32) PerAntWide<PackedCell*> dead_{};
  std::array<const float*, kAnts> row_{};
  std::array<WalkSlot*, kAnts> slots_{};
  AbreastPlanes planes_;
  PackedCell spare_ = 0;
};

}  // namespace
}  // namespace lasius::kernels
