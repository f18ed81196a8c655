// Walks that are cut short while what an ant entered is being forgotten.
#include <gtest/gtest.h>

#include <vector>

#include "core/base/poller.h"
#include "core/colony/walk_setup.h"
#include "core/colony/walkers.h"
#include "core/grid/move_rule.h"
#include "tests/core/base/counting_time.h"

namespace lasius {
namespace {

constexpr std::int64_t kPaces = 2 * Poller::kWords / 16;  // two looks while they are forgotten
bool found_marked = false;  // a cell beside the start, when an ant set out

// Leaves two dead ends, goes three cells east, then to and fro, and arrives after so many moves.
void pacing_kernel(const kernels::WalkWorld& world, std::span<kernels::WalkSlot> slots,
                   int rounds) noexcept {
  constexpr std::uint8_t kWest = 3, kEast = 4;
  const auto enter = [](const kernels::WalkSlot& slot, kernels::PackedCell c) {
    const bool marked = (*slot.visited.word(c) >> slot.visited.bit(c) & 1) != 0;
    found_marked |= marked && slot.move_count < 2;
    slot.visited.mark(c);
  };
  for (kernels::WalkSlot& slot : slots) {
    if (slot.state != kernels::WalkState::walking) continue;
    for (int y = 9; slot.move_count == 0 && slot.dead_count < 2; ++y) {
      enter(slot, slot.dead[slot.dead_count++] = kernels::pack(9, y));
    }
    for (int r = 0; r < rounds && slot.move_count < kPaces; ++r) {
      const std::uint8_t move = slot.move_count < 3 || slot.move_count % 2 == 0 ? kEast : kWest;
      slot.at += static_cast<kernels::PackedCell>(world.delta[move]);
      enter(slot, slot.at);
      slot.moves[slot.move_count++] = move;
    }
    if (slot.move_count == kPaces) slot.state = kernels::WalkState::arrived;
  }
}

TEST(Walkers, LeaveNoCellMarkedThatWasBeingForgottenWhenTimeWasUp) {
  const kernels::WalkWorld world =
      walk_world(Params("as"), moves_of(Neighbours::eight), {1, 1}, {99, 99});
  std::vector<Ant> ants(1);
  Walkers walkers;
  int arrived_late = 0, whole = 0;
  for (int looks = 0; whole < 2 && looks < 1000; ++looks) {
    walkers.reset(4096, 4096, 1, 1, false, {});  // so large that cells are cleared one by one
    const CountingTime time(looks);
    const auto cause = walkers.walk(world, pacing_kernel, ants, 0, time.is_up());
    ASSERT_FALSE(found_marked) << looks;
    if (cause == StopCondition::Cause::none)
      ++whole;
    else if (ants[0].arrived)
      ++arrived_late;
  }
  EXPECT_GE(arrived_late, 2);
  EXPECT_EQ(whole, 2);
}

}  // namespace
}  // namespace lasius
