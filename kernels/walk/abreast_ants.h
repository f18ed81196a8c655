// What groups of ants abreast share, whatever their lanes. The including file defines
// LASIUS_TARGET.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>

#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

LASIUS_TARGET [[gnu::always_inline]] inline __m128i four_bytes(
    const std::uint8_t* const* at) noexcept {
  const __m128i one = _mm_cvtsi32_si128(*at[0]);
  const __m128i two = _mm_insert_epi8(one, *at[1], 1);
  return _mm_insert_epi8(_mm_insert_epi8(two, *at[2], 2), *at[3], 3);
}

/// Up to eight ants, taken apart into arrays. `Lanes` says how wide a Number a lane has, and at
/// which place(i) of an array of pointers that of ant i stands.
template <class Lanes, int kMoves, bool kFactor, Draw kDraw>
struct AbreastAnts {
  static constexpr int kAnts = 8;
  static constexpr int kRounds = 4;  ///< steps between two looks at how many still walk
  static constexpr int kNumbersAStep = kDraw == Draw::discard ? kMoves : 1;
  static constexpr int kStepsABlock = numbers_of_block(kDraw) / kNumbersAStep;
  static_assert(kRounds % kStepsABlock == 0);

  using Number = typename Lanes::Number;
  alignas(64) std::array<Number, kAnts> at{};
  alignas(64) std::array<Number, kAnts> last{};               ///< moves; kMaxMoves at the start
  alignas(64) std::array<Number, kAnts> block{};              ///< next Philox counters
  alignas(64) std::array<Number, kAnts> number{};             ///< of the ants
  alignas(64) std::array<const float*, kAnts> row{};          ///< in the order of the ants
  alignas(64) std::array<const std::uint8_t*, kAnts> base{};  ///< of the tours
  alignas(64) std::array<std::uint8_t*, kAnts> top{};         ///< their ends
  alignas(64) std::array<PackedCell*, kAnts> dead{};
  std::array<WalkSlot*, kAnts> slots{};
  PackedCell spare = 0;

  void take(int i, WalkSlot& slot) noexcept {
    slots[i] = &slot;
    at[i] = slot.at;
    last[i] = slot.move_count > 0 ? slot.moves[slot.move_count - 1] : Number{kMaxMoves};
    block[i] = static_cast<Number>(slot.numbers_used(kDraw) / numbers_of_block(kDraw));
    number[i] = slot.ant;
    row[i] = slot.row;
    base[Lanes::place(i)] = slot.moves;
    top[Lanes::place(i)] = slot.moves + slot.move_count;
    dead[Lanes::place(i)] = slot.dead + slot.dead_count;
  }
  /// A lane without an ant is at a cell with a row like any other; its tour is spare memory.
  void rest(int i, PackedCell cell, const float* its_row) noexcept {
    at[i] = cell;
    last[i] = kMaxMoves;
    block[i] = number[i] = 0;
    row[i] = its_row;
    base[Lanes::place(i)] = top[Lanes::place(i)] = reinterpret_cast<std::uint8_t*>(&spare);
    dead[Lanes::place(i)] = &spare;
  }
  /// An ant that still walks; `word` as in WalkSlot.
  void hand_back(int i, std::uint64_t* word) const noexcept { hand_back(i, word, 0); }
  /// One that has ended in a round counted from 0; the numbers left of its block stay unread.
  void end(int i, std::uint64_t* word, WalkState state, int round) const noexcept {
    hand_back(i, word, (kStepsABlock - 1 - round % kStepsABlock) * kNumbersAStep);
    slots[i]->state = state;
  }

 private:
  void hand_back(int i, std::uint64_t* word, int unread) const noexcept {
    WalkSlot& slot = *slots[i];
    slot.at = static_cast<PackedCell>(at[i]);
    slot.row = row[i];
    slot.word = word;
    slot.move_count = top[Lanes::place(i)] - base[Lanes::place(i)];
    slot.dead_count = dead[Lanes::place(i)] - slot.dead;
    if (kFactor) slot.previous = static_cast<std::uint32_t>(last[i]);
    slot.random_block = static_cast<std::uint32_t>(block[i]);
    slot.random_used = static_cast<std::uint32_t>(WalkSlot::kNumbers - unread);
  }
};

}  // namespace
}  // namespace lasius::kernels
