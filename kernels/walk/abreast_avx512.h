// One step of eight ants abreast with AVX-512, an ant a lane; layouts as in abreast_avx512_lanes.h.
// The including file defines LASIUS_TARGET.
#pragma once

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "kernels/walk/abreast_ants.h"
#include "kernels/walk/abreast_avx512_draw.h"
#include "kernels/walk/abreast_avx512_lanes.h"
#include "kernels/walk/abreast_avx512_planes.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// Is there one of this shape? Where a row is eight floats: of eight moves, or of four by two
/// rules.
constexpr bool goes_abreast(WalkShape shape) noexcept {
  return shape.mixture ? shape.lanes == 4 && !shape.factor : shape.lanes == 8;
}

/// Up to eight ants. A step is made of the phases below, in their order.
template <int kMoves, bool kMixture, bool kFactor, Draw kDraw>
class Abreast {
  using DrawOf = AbreastDraw<kMixture>;
  static constexpr int kBack = 8;  ///< added to a move that is taken back

 public:
  using Ants = AbreastAnts<Lanes, kMoves, kFactor, kDraw>;
  static constexpr int kWorthwhile = 6;  ///< fewer are as fast one by one

  using Words = __m512i[4];
  using Weights = __m512[4];
  struct Step {
    __m512i move;  ///< one an ant, as all; above 32 bits undefined. kBack added when taken back
    __m512i from;
    __m512i to;
    __mmask8 walks;
    __mmask8 back;
  };

  /// Takes over ants under way, whose rows and words are found.
  LASIUS_TARGET Abreast(const WalkWorld& world, std::span<WalkSlot* const> slots) noexcept
      : planes_(slots.empty() ? 0 : slots[0]->visited.rows),
        walking_(static_cast<__mmask8>((1u << slots.size()) - 1)),
        no_return_(world.backtrack ? 0 : 0xff) {
    for (int i = 0; i < Ants::kAnts; ++i) {
      if (i < static_cast<int>(slots.size())) {
        take(i, *slots[i]);
      } else {
        rest(i);
      }
    }
    for (int k = 0; k < kMoves; ++k) {
      delta_[k] = world.delta[k];
      delta_[kBack + k] = -world.delta[k];
    }
    store(closed_, planes_.template closed<kMoves>(load(ants_.at), planes_.words()));
  }

  /// Bit i: ant i walks.
  unsigned walking() const noexcept { return walking_; }
  /// An ant that walks; the others were handed back when they ended.
  void hand_back(int i) const noexcept { ants_.hand_back(i, planes_.word(i)); }

  /// The next block of every ant, a word in each register, in halves; for a race turned in the
  /// second half.
  LASIUS_TARGET [[gnu::always_inline]] void draw_words(const WalkWorld& world,
                                                       Words& words) noexcept {
    const __m512i block = load(ants_.block);
    philox(world, block, load(ants_.number), words);
    for (__m512i& word : words) {
      word = in_halves(word);
      if constexpr (kDraw == Draw::discard) word = second_half_turned(word);
    }
    store(ants_.block, _mm512_add_epi64(block, all(1)));
  }

  /// The ants' rows, times the factors, in halves.
  LASIUS_TARGET [[gnu::always_inline]] void rows(const WalkWorld& world,
                                                 Weights& weight) const noexcept {
    const __m512 a = two_rows(world, 0), b = two_rows(world, 1);
    const __m512 c = two_rows(world, 2), d = two_rows(world, 3);
    const __m512d ab = _mm512_castps_pd(_mm512_unpacklo_ps(a, b));
    const __m512d cd = _mm512_castps_pd(_mm512_unpacklo_ps(c, d));
    const __m512d ab2 = _mm512_castps_pd(_mm512_unpackhi_ps(a, b));
    const __m512d cd2 = _mm512_castps_pd(_mm512_unpackhi_ps(c, d));
    weight[0] = _mm512_castpd_ps(_mm512_unpacklo_pd(ab, cd));
    weight[1] = _mm512_castpd_ps(_mm512_unpackhi_pd(ab, cd));
    weight[2] = _mm512_castpd_ps(_mm512_unpacklo_pd(ab2, cd2));
    weight[3] = _mm512_castpd_ps(_mm512_unpackhi_pd(ab2, cd2));
  }

  LASIUS_TARGET [[gnu::always_inline]] void draw(const WalkWorld& world, const Words& words,
                                                 int round, Weights& weight,
                                                 Step& step) const noexcept {
    const __m512i closed = in_halves(load(closed_));
    if constexpr (kDraw == Draw::discard) {
      step.move = DrawOf::race(words, closed, weight);
    } else {
      step.move = DrawOf::roulette(world, words[round], closed, weight);
    }
  }

  /// On by the move drawn, or back by the last one; the tours follow.
  LASIUS_TARGET [[gnu::always_inline]] void go(const WalkWorld&, Step& step, int round) noexcept {
    const __mmask8 stuck = _mm512_test_epi64_mask(step.move, all(DrawOf::kStuck));
    const __mmask8 at_start = _mm512_cmpeq_epi64_mask(load(ants_.top), load(ants_.base));
    const __mmask8 lost =
        _kand_mask8(_kand_mask8(walking_, stuck), _kor_mask8(at_start, no_return_));
    if (lost != 0) [[unlikely]]
      end(lost, WalkState::lost, round);
    step.walks = walking_;
    step.back = _kand_mask8(step.walks, stuck);
    step.move = _mm512_mask_or_epi64(step.move, step.back, load(ants_.last), all(kBack));
    step.from = load(ants_.at);
    step.to =
        _mm512_mask_add_epi64(step.from, step.walks, step.from,
                              _mm512_permutex2var_epi64(_mm512_load_si512(delta_.data()), step.move,
                                                        _mm512_load_si512(delta_.data() + kBack)));

    const __mmask8 on = _kandn_mask8(step.back, step.walks);
    const __m512i top = load(ants_.top), below = _mm512_add_epi64(top, all(-1));
    const __m512i place = _mm512_mask_mov_epi64(top, step.back, below);
    const __m512i new_top = _mm512_mask_add_epi64(place, on, place, all(1));

    // The last move of those that went back; before the stores, so that no load waits for them.
    static constexpr std::uint8_t kNoMove = kMaxMoves;
    const __mmask8 no_move = _mm512_cmpeq_epi64_mask(place, load(ants_.base));
    alignas(64) PerAnt<const std::uint8_t*> before;
    store(before, _mm512_mask_mov_epi64(_mm512_add_epi64(place, all(-1)), no_move,
                                        all(std::bit_cast<std::int64_t>(&kNoMove))));
    const __m128i last = _mm_unpacklo_epi32(four_bytes(&before[0]), four_bytes(&before[4]));
    store(ants_.last, _mm512_mask_and_epi64(_mm512_cvtepu8_epi64(last), on, step.move, all(7)));

    // Who goes on writes its move, and three bytes that do not count yet; who goes back the cell it
    // leaves.
    alignas(64) PerAnt<void*> places;
    alignas(64) PerAnt<std::uint64_t> written;
    store(places, _mm512_mask_mov_epi64(top, step.back, load(ants_.dead)));
    store(written, _mm512_mask_mov_epi64(step.move, step.back, step.from));
    for (int i = 0; i < Ants::kAnts; ++i) std::memcpy(places[i], &written[i], sizeof(PackedCell));
    store(ants_.dead, _mm512_mask_add_epi64(load(ants_.dead), step.back, load(ants_.dead), all(4)));
    store(ants_.top, new_top);
    store(ants_.at, step.to);
  }

  /// Finds what belongs to the cells. Without a branch on whether an ant leaves its tile: of eight,
  /// one often does.
  LASIUS_TARGET [[gnu::always_inline]] void find(const WalkWorld& world, const Step& step) {
    const __m512i x = _mm512_and_epi64(step.to, all(0xffff)), y = _mm512_srli_epi64(step.to, 16);
    const __m512i tile_x = _mm512_srli_epi64(x, kTileShift);
    const __m512i tile = _mm512_add_epi64(
        _mm512_mul_epu32(_mm512_srli_epi64(y, kTileShift), all(world.tiles_x)), tile_x);
    alignas(64) PerAnt<std::int64_t> number;
    store(number, tile);
    __m512i tile_rows = tiles(world, number);
    unsigned missing = _mm512_mask_testn_epi64_mask(step.walks, tile_rows, tile_rows);
    if (missing != 0) [[unlikely]] {
      for (; missing != 0; missing &= missing - 1) {
        world.make_tile(world.context, static_cast<int>(number[__builtin_ctz(missing)]));
      }
      tile_rows = tiles(world, number);
    }
    const __m512i in_tile = all(kTileSide - 1);
    const __m512i cell = _mm512_or_epi64(
        _mm512_slli_epi64(_mm512_and_epi64(y, in_tile), kTileShift), _mm512_and_epi64(x, in_tile));
    constexpr int kRowShift = 5;  // 32 bytes
    store(ants_.row, _mm512_mask_add_epi64(load(ants_.row), step.walks, tile_rows,
                                           _mm512_slli_epi64(cell, kRowShift)));
    for (const float* row : ants_.row) __builtin_prefetch(row);
    planes_.find(step.walks, x, y);
  }

  /// Sees what is closed around the new cells and marks them as entered; ends who has arrived.
  LASIUS_TARGET [[gnu::always_inline]] void enter(const WalkWorld& world, const Step& step,
                                                  int round) noexcept {
    const auto words = planes_.words();
    // Before it is marked, so that no load waits for the stores; a cell is not its own neighbour.
    store(closed_, planes_.template closed<kMoves>(step.to, words));
    planes_.mark(walking_, step.to, words);
    const __mmask8 arrived =
        _mm512_mask_cmpeq_epi64_mask(_kandn_mask8(step.back, step.walks), step.to, all(world.goal));
    if (arrived != 0) [[unlikely]]
      end(arrived, WalkState::arrived, round);
  }

 private:
  /// Those of ants i and i + 4.
  LASIUS_TARGET [[gnu::always_inline]] __m512 two_rows(const WalkWorld& world,
                                                       int i) const noexcept {
    const __m512 row = two_at(ants_.row[i], ants_.row[i + 4]);
    if constexpr (!kFactor) return row;
    return _mm512_mul_ps(
        row, two_at(world.factor[ants_.last[i]].data(), world.factor[ants_.last[i + 4]].data()));
  }
  LASIUS_TARGET [[gnu::always_inline]] static __m512 two_at(const float* low,
                                                            const float* high) noexcept {
    return _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(low)), _mm256_load_ps(high), 1);
  }

  LASIUS_TARGET [[gnu::always_inline]] static __m512i tiles(
      const WalkWorld& world, const PerAnt<std::int64_t>& number) noexcept {
    PerAnt<const float*> rows;
    for (int i = 0; i < Ants::kAnts; ++i) {
      rows[i] = __atomic_load_n(world.tiles + number[i], __ATOMIC_ACQUIRE);
    }
    return eight(two(rows[0], rows[1]), two(rows[2], rows[3]), two(rows[4], rows[5]),
                 two(rows[6], rows[7]));
  }

  void take(int i, WalkSlot& slot) noexcept {
    planes_.take(i, slot);
    ants_.take(i, slot);
  }
  /// A lane without an ant steps on the spot, in memory of its own.
  void rest(int i) noexcept {
    planes_.rest(i);
    ants_.rest(i, 0, kNoRow.data());
  }
  /// Who has ended, `round` counted from 0.
  void end(__mmask8 which, WalkState state, int round) noexcept {
    walking_ = static_cast<__mmask8>(walking_ & ~which);
    for (unsigned left = which; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      ants_.end(i, planes_.word(i), state, round);
      rest(i);
    }
  }

  alignas(32) static constexpr std::array<float, 8> kNoRow{};

  Ants ants_;
  AbreastPlanes planes_;
  alignas(64) PerAnt<std::uint64_t> closed_{};               ///< bit k: move k is
  alignas(64) std::array<std::int64_t, 2 * kBack> delta_{};  ///< by move, then back over it
  __mmask8 walking_ = 0;
  __mmask8 no_return_ = 0;
};

}  // namespace
}  // namespace lasius::kernels
