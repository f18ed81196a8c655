// The ants of a group that walks in lock-step, taken apart into arrays that vectors load.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/walk/avx2_vectors.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// Up to eight ants.
template <int kMoves, bool kFactor, Draw kDraw>
struct LockstepAnts {
  static constexpr int kAnts = 8;
  static constexpr int kRounds = 4;  ///< steps between two looks at how many still walk
  static constexpr int kNumbersAStep = kDraw == Draw::discard ? kMoves : 1;
  static constexpr int kStepsABlock = numbers_of_block(kDraw) / kNumbersAStep;
  static_assert(kRounds % kStepsABlock == 0);

  alignas(64) PerAnt at{};
  alignas(64) PerAnt last{};                           ///< moves; kMaxMoves at the start
  alignas(64) PerAnt block{};                          ///< next Philox counters
  alignas(64) PerAnt number{};                         ///< of the ants
  alignas(64) std::array<const float*, kAnts> row{};   ///< in the order of the ants
  alignas(64) PerAntWide<const std::uint8_t*> base{};  ///< where the tours begin
  alignas(64) PerAntWide<std::uint8_t*> top{};         ///< where they end
  alignas(64) PerAntWide<PackedCell*> dead{};          ///< where the cells left again end
  std::array<WalkSlot*, kAnts> slots{};
  PackedCell spare = 0;

  void take(int i, WalkSlot& slot) noexcept {
    slots[i] = &slot;
    at[i] = slot.at;
    last[i] = slot.move_count > 0 ? slot.moves[slot.move_count - 1] : std::uint32_t{kMaxMoves};
    block[i] = static_cast<std::uint32_t>(slot.numbers_used(kDraw) / numbers_of_block(kDraw));
    number[i] = slot.ant;
    row[i] = slot.row;
    base[place(i)] = slot.moves;
    top[place(i)] = slot.moves + slot.move_count;
    dead[place(i)] = slot.dead + slot.dead_count;
  }
  /// A lane without an ant: at a cell with a row like any other, with spare memory for a tour.
  void leave_empty(int i, PackedCell cell, const float* its_row) noexcept {
    at[i] = cell;
    last[i] = kMaxMoves;
    block[i] = number[i] = 0;
    row[i] = its_row;
    base[place(i)] = top[place(i)] = reinterpret_cast<std::uint8_t*>(&spare);
    dead[place(i)] = &spare;
  }
  /// An ant that still walks; `word` as in WalkSlot.
  void hand_back(int i, std::uint64_t* word) const noexcept { hand_back(i, word, 0); }
  /// One that has ended in a round counted from 0; the numbers left of its block are dropped.
  void end(int i, std::uint64_t* word, WalkState state, int round) const noexcept {
    hand_back(i, word, (kStepsABlock - 1 - round % kStepsABlock) * kNumbersAStep);
    slots[i]->state = state;
  }

 private:
  void hand_back(int i, std::uint64_t* word, int unread) const noexcept {
    WalkSlot& slot = *slots[i];
    slot.at = at[i];
    slot.row = row[i];
    slot.word = word;
    slot.move_count = top[place(i)] - base[place(i)];
    slot.dead_count = dead[place(i)] - slot.dead;
    if (kFactor) slot.previous = last[i];
    slot.random_block = block[i];
    slot.random_used = static_cast<std::uint32_t>(WalkSlot::kNumbers - unread);
  }
};

}  // namespace
}  // namespace lasius::kernels
