// The lock-step SIMD walk, one ant a lane: eight ants take each step together. What one ant waits
// for in a step (its row, the sums, the draw, the next row) eight wait for at once, and turning
// back costs no branch. Two such groups alternate, so that one works while the other waits.
#pragma once

#include <bit>
#include <cstddef>
#include <span>

#include "kernels/walk/lockstep_group.h"
#include "kernels/walk/row_draw.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// LockstepAnts::kRounds steps of every ant of the groups.
template <class Group, int kGroups>
LASIUS_AVX2 void advance(const WalkWorld& world, Group* const (&groups)[kGroups]) {
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

/// What walk_body.h asks for, in registers as AVX2 has them.
struct VectorOps : RowDraw {
  /// Advances ants that walk by up to `rounds` steps and returns how many it did; none where too
  /// few walk, or where a row has more than eight moves.
  template <int kLanes, bool kMixture, bool kFactor, Draw kDraw>
  LASIUS_AVX2 static int lockstep(const WalkWorld& world, std::span<WalkSlot* const> slots,
                                  int rounds) {
    if constexpr (kLanes > 8) {
      return 0;
    } else {
      using Group = LockstepGroup<kLanes, kMixture, kFactor, kDraw>;
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
