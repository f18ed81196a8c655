// Ants abreast: one step of eight ants at once, an ant a lane. What one ant waits for in a step
// (its row, the sums, the draw, the next row) eight wait for together, and turning back costs no
// branch. Two such groups take turns, so that one works while the other waits. The including file
// defines LASIUS_TARGET and includes walk_vector.h and, of AVX2 or of AVX-512, an `Abreast` with
// its `goes_abreast`.
#pragma once

#include <bit>
#include <cstddef>
#include <span>

#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// AbreastAnts::kRounds steps of every ant of the groups.
template <class Group, int kGroups>
LASIUS_TARGET void advance(const WalkWorld& world, Group* const (&groups)[kGroups]) {
  typename Group::Words words[kGroups];
  for (int round = 0; round < Group::Ants::kRounds; ++round) {
    if (round % Group::Ants::kStepsABlock == 0) {
      for (int g = 0; g < kGroups; ++g) groups[g]->draw_words(world, words[g]);
    }
    // Phase by phase, so that the groups' chains are in flight together.
    typename Group::Weights weights[kGroups];
    typename Group::Step steps[kGroups];
#pragma GCC unroll 2
    for (int g = 0; g < kGroups; ++g) groups[g]->rows(world, weights[g]);
#pragma GCC unroll 2
    for (int g = 0; g < kGroups; ++g) {
      groups[g]->draw(world, words[g], round, weights[g], steps[g]);
    }
#pragma GCC unroll 2
    for (int g = 0; g < kGroups; ++g) groups[g]->go(world, steps[g], round);
#pragma GCC unroll 2
    for (int g = 0; g < kGroups; ++g) groups[g]->find(world, steps[g]);
#pragma GCC unroll 2
    for (int g = 0; g < kGroups; ++g) groups[g]->enter(world, steps[g], round);
  }
}

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
      using Ants = typename Group::Ants;
      const std::size_t half = slots.size() <= Ants::kAnts ? slots.size() : (slots.size() + 1) / 2;
      if (slots.size() < Group::kWorthwhile || slots.size() > 2 * Ants::kAnts) return 0;
      for (const WalkSlot* slot : slots) {
        if (slot->numbers_used(kDraw) % numbers_of_block(kDraw) != 0) return 0;
      }
      Group one(world, slots.first(half)), other(world, slots.subspan(half));
      const auto walking = [&] {
        return std::popcount(one.walking()) + std::popcount(other.walking());
      };
      int done = 0;
      for (; rounds - done >= Ants::kRounds && walking() >= Group::kWorthwhile;
           done += Ants::kRounds) {
        if (other.walking() == 0) {
          advance<Group>(world, {&one});
        } else {
          advance<Group>(world, {&one, &other});
        }
      }
      for (const Group* group : {&one, &other}) {
        for (unsigned left = group->walking(); left != 0; left &= left - 1) {
          group->hand_back(std::countr_zero(left));
        }
      }
      return done;
    }
  }
};

}  // namespace
}  // namespace lasius::kernels
