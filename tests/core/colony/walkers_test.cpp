#include "core/colony/walkers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "core/base/kernel_choice.h"
#include "core/base/poller.h"
#include "core/colony/field.h"
#include "core/colony/walk_setup.h"
#include "core/grid/move_rule.h"
#include "lasius/params/schedule.h"
#include "tests/core/base/counting_time.h"
#include "tests/kernels/base/instruction_sets.h"
#include "tests/worlds/planning.h"

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
  Params params("fan2004");
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
  walkers.reset(grid.width(), grid.height(), 1, params.ants, false, {});
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

using kernels::kTileCells;
using kernels::kTileSide;

constexpr int kSide = 5 * kTileSide;
constexpr int kTiles = 5 * 5;
constexpr int kAnts = 20;

/// A square without obstacles, every move of weight 1, whose tiles can run out.
class Square {
 public:
  explicit Square(int tiles) : left_(tiles) {
    const Params params("as");
    const kernels::Moves moves = moves_of(Neighbours::eight);
    shape = walk_shape(params, moves, false);
    world = walk_world(params, moves, {1, 1}, {kSide - 2, kSide - 2});
    set_iteration(world, params, moves, shape, schedule(params, 0), 0);
    world.tiles = rows_.data();
    world.tiles_x = kSide / kTileSide;
    world.context = this;
    world.make_tile = [](void* square, int tile) {
      return static_cast<Square*>(square)->make(tile);
    };
    moves_ = moves;
  }

  kernels::WalkWorld world;
  kernels::WalkShape shape;

 private:
  struct alignas(64) Rows {
    float weights[kTileCells * 8];
  };

  float* make(int tile) {
    const std::scoped_lock lock(making_);
    if (rows_[tile] != nullptr) return rows_[tile];
    if (left_-- == 0) throw std::bad_alloc();
    tiles_.push_back(std::make_unique<Rows>());
    float* weight = tiles_.back()->weights;
    const int x0 = tile % world.tiles_x * kTileSide, y0 = tile / world.tiles_x * kTileSide;
    for (int cell = 0; cell < kTileCells; ++cell) {
      for (int k = 0; k < 8; ++k) {
        const int x = x0 + cell % kTileSide + moves_[k].to.dx;
        const int y = y0 + cell / kTileSide + moves_[k].to.dy;
        *weight++ = x >= 0 && y >= 0 && x < kSide && y < kSide ? 1.0f : 0.0f;
      }
    }
    float* rows = tiles_.back()->weights;
    __atomic_store_n(&rows_[tile], rows, __ATOMIC_RELEASE);
    return rows;
  }

  kernels::Moves moves_;
  int left_;
  std::mutex making_;
  std::vector<std::unique_ptr<Rows>> tiles_;
  std::vector<float*> rows_ = std::vector<float*>(kTiles, nullptr);
};

using Tours = std::vector<std::vector<std::uint8_t>>;

Tours tours(Walkers& walkers, kernels::Isa isa, int threads, int tiles = kTiles) {
  Square square(tiles);
  std::vector<Ant> ants(kAnts);
  walkers.reset(kSide, kSide, threads, kAnts, false, {});
  walkers.walk(square.world, kernels::walk_table(isa).walk[square.shape.index()], ants, 0, {});
  Tours result;
  for (const Ant& ant : ants) {
    EXPECT_TRUE(ant.arrived);
    result.emplace_back(ant.tour().begin(), ant.tour().end());
  }
  return result;
}

TEST(Walkers, PassOnThatATileCannotBeMadeAndForgetTheAntsUnderWay) {
  for (const auto isa : kernels::supported_isas()) {
    Walkers fresh;
    const Tours expected = tours(fresh, isa, 1);
    for (const int threads : {1, 3}) {
      Walkers walkers;
      for (const int tiles : {0, 1, 5, 20}) {
        EXPECT_THROW(tours(walkers, isa, threads, tiles), std::bad_alloc);
        EXPECT_EQ(tours(walkers, isa, threads), expected);
      }
    }
  }
}

TEST(Walkers, LeaveAntsThatAreCutShortAndWalkAsBeforeAfterAReset) {
  Walkers fresh;
  const Tours expected = tours(fresh, chosen_isa(), 1);
  for (const int threads : {1, 3}) {
    Walkers walkers;
    for (const int looks : {0, 1, 2, 3, 5}) {
      Square square(kTiles);
      std::vector<Ant> ants(kAnts);
      walkers.reset(kSide, kSide, threads, kAnts, false, {});
      std::vector<int> ended(kAnts, 0);
      const CountingTime time(looks);
      const auto cause =
          walkers.walk(square.world, kernels::walk_table(chosen_isa()).walk[square.shape.index()],
                       ants, 0, time.is_up(), {.ended = [&](int ant, int) { ++ended[ant]; }});
      EXPECT_EQ(cause, StopCondition::Cause::deadline) << looks;
      int arrived = 0;
      for (int a = 0; a < kAnts; ++a) {
        EXPECT_EQ(ended[a], ants[a].arrived) << looks << " " << a;
        arrived += ants[a].arrived;
      }
      EXPECT_LT(arrived, kAnts) << looks;
      EXPECT_EQ(tours(walkers, chosen_isa(), threads), expected) << looks;
    }
  }
}

constexpr int kLongCalls = Poller::kWords / 128 + 1;  // of a kernel, until a tour is long
int long_calls = 0;
std::vector<std::uint32_t> long_walking;  // ants that were under way after these calls

// Fills all the room that it is given; ant 1 arrives when its tour is long.
void long_kernel(const kernels::WalkWorld&, std::span<kernels::WalkSlot> slots,
                 int rounds) noexcept {
  ++long_calls;
  for (kernels::WalkSlot& slot : slots) {
    if (slot.state != kernels::WalkState::walking) continue;
    if (long_calls > kLongCalls) long_walking.push_back(slot.ant);
    std::fill_n(slot.moves + slot.move_count, rounds, std::uint8_t{0});
    slot.move_count += rounds;
    if (slot.ant == 1 && long_calls == kLongCalls) slot.state = kernels::WalkState::arrived;
  }
}

TEST(Walkers, LeaveAloneAntsThatWereCutShortWhileALongTourWasForgotten) {
  Square square(kTiles);
  std::vector<Ant> ants(kAnts);
  Walkers walkers;
  walkers.reset(4096, 4096, 1, kAnts, false, {});  // to be cleared with eight looks at the clock
  long_calls = 0;
  long_walking.clear();
  const CountingTime time(kLongCalls);  // a look a call, and the first of those
  const auto cause = walkers.walk(square.world, long_kernel, ants, 0, time.is_up());
  EXPECT_EQ(cause, StopCondition::Cause::deadline);
  EXPECT_GT(ants[1].move_count, Poller::kWords);
  EXPECT_EQ(long_walking, (std::vector<std::uint32_t>{0}));  // its turn had passed
  for (int a = 0; a < kAnts; ++a) EXPECT_EQ(ants[a].arrived, a == 1);
  EXPECT_EQ(tours(walkers, chosen_isa(), 1).size(), kAnts);
}

// Its ants enter a cell in each page of their planes.
void roaming_kernel(const kernels::WalkWorld&, std::span<kernels::WalkSlot> slots, int) noexcept {
  for (kernels::WalkSlot& slot : slots) {
    for (int y = 0; y < 4096; y += 256) {
      for (int x = 0; x < 4096; x += 32) slot.visited.mark(kernels::pack(x, y));
    }
  }
}

// Never up; notes the most memory that was given back between two looks.
class GivenBackBetweenLooks final : public TimeSource {
 public:
  explicit GivenBackBetweenLooks(const Walkers& walkers)
      : walkers_(walkers), before_(walkers.bytes()) {}
  Clock::time_point now() const noexcept override {
    const std::int64_t bytes = walkers_.bytes();
    most_ = std::max(most_, before_ - bytes);
    before_ = bytes;
    return {};
  }
  std::int64_t most() const noexcept { return most_; }

 private:
  const Walkers& walkers_;
  mutable std::int64_t before_, most_ = 0;
};

TEST(Walkers, GiveThePagesOfLargePlanesBackAndLookAtTheClockMeanwhile) {
  const Tours expected = [] {
    Walkers fresh;
    return tours(fresh, chosen_isa(), 1);
  }();
  Walkers walkers;
  const auto roam = [&] {
    Square square(kTiles);
    std::vector<Ant> ants(kAnts);
    const CountingTime time(0);
    walkers.reset(4096, 4096, 1, kAnts, false, {});
    walkers.walk(square.world, roaming_kernel, ants, 0, time.is_up());
  };
  roam();
  const auto full = walkers.bytes();
  EXPECT_GT(full, 16 * 4'000'000);
  const CountingTime up(20);
  walkers.reset(4096, 4096, 1, kAnts, false, up.is_up());
  EXPECT_EQ(up.polls(), 21);
  EXPECT_GT(walkers.bytes(), full / 2);
  const GivenBackBetweenLooks time(walkers);
  walkers.reset(4096, 4096, 1, kAnts, false,
                {.deadline = Clock::time_point{} + std::chrono::hours(1), .time = &time});
  EXPECT_GT(time.most(), 0);
  EXPECT_LT(time.most(), 2 * 8 * Poller::kWords);
  EXPECT_LT(walkers.bytes(), 100'000);
  roam();
  EXPECT_EQ(tours(walkers, chosen_isa(), 1), expected);  // in the same planes
}

std::atomic<bool> all_sent = false;
std::atomic<int> spared = 0;  // ants given to a thread without others to walk

// Ants arrive once both threads have theirs; the first one waits for an ant to be given away.
void waiting_kernel(const kernels::WalkWorld&, std::span<kernels::WalkSlot> slots, int) noexcept {
  for (kernels::WalkSlot& slot : slots) {
    if (slot.state != kernels::WalkState::walking) continue;
    if (slot.ant + 1 == kAnts) all_sent = true;
    if (all_sent && (slot.ant > 0 || spared > 0)) slot.state = kernels::WalkState::arrived;
  }
}

TEST(Walkers, GiveAThreadThatHasNoAntLeftThoseItHasWalked) {
  Square square(kTiles);
  std::vector<Ant> ants(kAnts);
  Walkers walkers;
  walkers.reset(kSide, kSide, 2, kAnts, false, {});
  std::vector<int> ended(kAnts, 0), given(kAnts, 0);
  AfterWalk after;
  after.ended = [&](int ant, int thread) {
    EXPECT_TRUE(ants[ant].arrived);
    EXPECT_TRUE(thread == 0 || thread == 1);
    ++ended[ant];
  };
  after.spare = [&](int ant, int thread) {
    EXPECT_EQ(ended[ant], 1);
    EXPECT_TRUE(thread == 0 || thread == 1);
    ++given[ant];
    ++spared;
  };
  const auto cause = walkers.walk(square.world, waiting_kernel, ants, 0,
                                  {.deadline = Clock::now() + std::chrono::minutes(1)}, after);
  EXPECT_EQ(cause, StopCondition::Cause::none);
  EXPECT_EQ(ended, std::vector<int>(kAnts, 1));
  EXPECT_GT(spared, 0);
  EXPECT_EQ(given[0], 0);  // it was the last one under way
  EXPECT_LE(*std::max_element(given.begin(), given.end()), 1);
  for (const Ant& ant : ants) EXPECT_TRUE(ant.arrived);
}

TEST(Walkers, GiveOneThreadAloneNothing) {
  Square square(kTiles);
  std::vector<Ant> ants(kAnts);
  Walkers walkers;
  walkers.reset(kSide, kSide, 1, kAnts, false, {});
  walkers.walk(square.world, kernels::walk_table(kernels::Isa::scalar).walk[square.shape.index()],
               ants, 0, {}, {.spare = [](int, int) { FAIL(); }});
  for (const Ant& ant : ants) EXPECT_TRUE(ant.arrived);
}

}  // namespace
}  // namespace lasius
