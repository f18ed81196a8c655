// Ants abreast: one step of eight ants at once, an ant a lane. What one ant waits for in a step
// (its row, the sums, the draw, the next row) eight wait for together, and turning back costs no
// branch. Two such groups take turns, so that one works while the other waits. The including file
// defines LASIUS_TARGET and includes walk_vector.h and, of AVX2 or of AVX-512, an `Abreast` with
// its `goes_abreast`.
#pragma once

#include <cstddef>
#include <span>

#include "kernels/walk.h"

namespace lasius::kernels {
namespace {

/// As VectorOps, with the steps that are done abreast.
struct AbreastOps : VectorOps {
  /// Advances ants that walk by up to `rounds` steps and returns how many it did; none where too
  /// few walk, or where the shape has no such kernel.
  template <int kLanes, bool kMixture, bool kFactor, Draw kDraw>
  LASIUS_TARGET static int abreast(const WalkWorld& world, std::span<WalkSlot* const> slots,
                                   int rounds) {
    if constexpr (!goes_abreast({kLanes, kMixture, kFactor, kDraw})) {
      return 0;
    } else {
      using Group = Abreast<kLanes, kMixture, kFactor, kDraw>;
      const std::size_t half = slots.size() <= Group::kAnts ? slots.size() : (slots.size() + 1) / 2;
      if (slots.size() < Group::kWorthwhile || slots.size() > 2 * Group::kAnts) return 0;
      for (const WalkSlot* slot : slots) {
        if (slot->words_used() % 4 != 0) return 0;  // within a Philox block
      }
      Group one(world, slots.first(half)), other(world, slots.subspan(half));
      int done = 0;
      for (;
           rounds - done >= Group::kRounds && one.walking() + other.walking() >= Group::kWorthwhile;
           done += Group::kRounds) {
        if (other.walking() == 0) {
          Group::advance(world, {&one});
        } else {
          Group::advance(world, {&one, &other});
        }
      }
      one.hand_back();
      other.hand_back();
      return done;
    }
  }
};

}  // namespace
}  // namespace lasius::kernels
