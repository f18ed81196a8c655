#include "walkers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "field.h"
#include "kernel_choice.h"
#include "move_rule.h"
#include "schedule.h"
#include "tests/core/planning.h"
#include "walk_setup.h"

namespace lasius {
namespace {

std::int64_t steps_allowed = 0;  // since the last look at the clock
std::int64_t most_allowed = 0;

// Never up; notes the most steps that were allowed between two looks.
class StepsBetweenLooks final : public TimeSource {
 public:
  Clock::time_point now() const noexcept override {
    most_allowed = std::max(most_allowed, steps_allowed);
    steps_allowed = 0;
    return {};
  }
};

kernels::WalkFn real_kernel = nullptr;

void counted_kernel(const kernels::WalkWorld& world, std::span<kernels::WalkSlot> slots,
                    int rounds) noexcept {
  steps_allowed += static_cast<std::int64_t>(slots.size()) * rounds;
  real_kernel(world, slots, rounds);
}

TEST(Walkers, PollAtLeastEvery4096Steps) {
  const Grid grid = blobs(300, 300);
  const Planner planner(grid);
  const Request request = far_apart(planner);
  Params params = defaults("fan2004");
  params.heuristic = Heuristic::uniform;  // no guidance to speak of: long walks
  params.ants = 20;
  const kernels::Moves moves = moves_of(params.neighbours);
  const StepWeights weights = schedule(params, 0);
  Field field;
  field.reset(grid, moves, request.goal, params, 1, {});
  field.refresh(weights, 1);
  const kernels::WalkShape shape = walk_shape(params, moves, field.mixture());
  kernels::WalkWorld world = walk_world(params, moves, request.start, request.goal);
  set_iteration(world, params, moves, shape, weights, 0);
  field.fill(world);
  Walkers walkers;
  walkers.reset(grid.width(), grid.height(), 1, params.ants);
  real_kernel = kernels::walk_table(chosen_isa()).walk[shape.index()];
  std::vector<Ant> ants(static_cast<std::size_t>(params.ants));
  const StepsBetweenLooks time;
  const auto cause =
      walkers.walk(world, counted_kernel, ants, 0,
                   {.deadline = Clock::time_point{} + std::chrono::hours(1), .time = &time});
  EXPECT_EQ(cause, StopCondition::Cause::none);
  std::int64_t steps = 0;
  for (const Ant& ant : ants) steps += ant.steps;
  EXPECT_GT(steps, 20 * 4096);
  EXPECT_EQ(steps_allowed, 0);  // it looks after the last steps, too
  EXPECT_GT(most_allowed, 0);
  EXPECT_LE(most_allowed, 4096);
}

}  // namespace
}  // namespace lasius
