// Sends the ants of one iteration through the walk kernel, over threads.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/grid/move_rule.h"
#include "kernels/walk/walk.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// One ant's walk. Buffers keep their size between iterations and plans. Cache lines of its own:
/// threads walk neighbours.
struct alignas(64) Ant {
  bool arrived = false;
  GrowingArray<std::uint8_t> moves;  // of the tour
  std::int64_t move_count = 0;
  GrowingArray<kernels::PackedCell> dead;  // cells entered and left again, where they are wanted
  std::int64_t dead_count = 0;
  GrowingArray<std::uint8_t> cut;  // moves of the tour after the cut
  std::int64_t cut_count = -1;     // of these; -1 where the tour is not cut
  std::int64_t steps = 0;          // steps done, those taken back included
  std::int64_t near = 0;           // cells of the tour near the straight line

  std::span<const std::uint8_t> tour() const noexcept {
    return {moves.data(), static_cast<std::size_t>(move_count)};
  }
  std::span<const std::uint8_t> left() const noexcept {  // of the tour, after the cut
    if (cut_count < 0) return tour();
    return {cut.data(), static_cast<std::size_t>(cut_count)};
  }
  std::span<const kernels::PackedCell> dead_ends() const noexcept {
    return {dead.data(), static_cast<std::size_t>(dead_count)};
  }
  std::int64_t bytes() const noexcept {
    return moves.bytes() + dead.bytes() + cut.bytes();
  }  // memory held
};

/// Calls visit(cell) for every cell of a tour, the start first.
template <class Visit>
void along_tour(std::span<const std::uint8_t> tour, const kernels::Moves& moves, Cell start,
                const Visit& visit) {
  Cell c = start;
  visit(c);
  for (const int k : tour) {
    c = c + moves[k].to;
    visit(c);
  }
}

/// What is done with an ant, by index, that has arrived or is lost. Threads have numbers from 0.
struct AfterWalk {
  using Action = std::function<void(int ant, int thread)>;
  Action ended = {};  ///< at once, by the thread that walked it
  Action spare = {};  ///< by that thread once it has no ant to walk, while others have
};

/// Ants under way, a few a thread, with the cells that each has entered.
class Walkers {
 public:
  /// Gets ready for a grid of this size. Address space is reserved by area, memory touched only
  /// where ants go; of large planes it is given back here. Ants tell what cells they left again
  /// only if these are `dead_wanted`. When stopped, another reset is to come before a walk.
  void reset(int width, int height, int threads, int ants, bool dead_wanted,
             const StopCondition& stop);

  /// Walks every ant until it has arrived or is lost, or `stop` says so; then ants still under way
  /// and those not yet sent have neither arrived nor ended, and `reset` is to be called before the
  /// next walk. `first` is the number of the first ant, which picks its random stream. Which thread
  /// walks which ant changes nothing. Throws what the world's make_tile throws, or std::bad_alloc;
  /// then call `reset`, too.
  StopCondition::Cause walk(const kernels::WalkWorld& world, kernels::WalkFn kernel,
                            std::span<Ant> ants, int first, const StopCondition& stop,
                            const AfterWalk& after = {});

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  // Ants that one thread advances together: two groups of eight, where they walk in lock-step.
  static constexpr int kSlots = 16;
  static constexpr int kRounds = 128;
  static_assert(kSlots <= kernels::kMaxSlots && std::int64_t{kSlots} * kRounds <= Poller::kSteps);

  struct Slot {
    ZeroArray<std::uint64_t> plane;          // pages that no ant touches stay unmapped
    GrowingArray<kernels::PackedCell> dead;  // of the ant, where they are not wanted
    bool marked = false;                     // a walk was cut short, whose cells are still marked
  };
  struct alignas(64) ThreadScratch {  // of one thread
    std::array<Slot, kSlots> slots;
    std::vector<int> done;  // ants, by index
  };

  // Of so many ants, those that a thread has under way: no more than its share.
  int slots_for(int ants) const noexcept {
    return std::min(kSlots, (ants + threads_ - 1) / threads_);
  }
  /// One call of `walk`, as its threads share it.
  struct Sending {
    const kernels::WalkWorld& world;
    kernels::WalkFn kernel;
    std::span<Ant> ants;
    int first;
    const StopCondition& stop;
    const AfterWalk& after;
    std::atomic<int> next{0};  // ant to be sent
    std::atomic<StopCondition::Cause> cause{StopCondition::Cause::none};

    /// True once a thread has seen that the walk is to be cut short; then nobody sends another ant.
    bool cut_short() noexcept;
  };
  class Worker;

  std::vector<ThreadScratch> scratch_;
  int threads_ = 1;
  bool dead_wanted_ = false;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace lasius
