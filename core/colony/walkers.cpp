#include "core/colony/walkers.h"

#include "core/base/held_bytes.h"
#include "core/base/parallel.h"

namespace lasius {

using kernels::PackedCell;
using kernels::VisitedPlane;
using kernels::WalkSlot;
using kernels::WalkState;
using kernels::WalkWorld;

void Walkers::reset(int width, int height, int threads, int ants, bool dead_wanted,
                    const StopCondition& stop) {
  dead_wanted_ = dead_wanted;
  width_ = width;
  height_ = height;
  threads_ = std::clamp(ants / 2, 1, threads);  // more would idle
  if (static_cast<int>(scratch_.size()) < threads_) scratch_.resize(threads_);
  // Those that are not needed this time give their memory back, too.
  Poller poller(stop);
  const auto words = VisitedPlane::words_for(width, height);
  for (int t = 0; t < static_cast<int>(scratch_.size()); ++t) {
    scratch_[t].done.reserve(ants);
    for (int i = 0; i < kSlots; ++i) {
      Slot& slot = scratch_[t].slots[i];
      const bool needed = t < threads_ && i < slots_for(ants);
      if (!slot.plane.renew(needed ? words : 0, slot.marked, poller)) return;
      slot.marked = false;
    }
  }
}

std::int64_t Walkers::bytes() const noexcept {
  std::int64_t bytes = held_bytes(scratch_);
  for (const ThreadScratch& scratch : scratch_) {
    bytes += held_bytes(scratch.done);
    for (const Slot& slot : scratch.slots) bytes += slot.plane.bytes() + slot.dead.bytes();
  }
  return bytes;
}

bool Walkers::Sending::cut_short() noexcept {
  if (const auto seen = stop.poll(); seen != StopCondition::Cause::none) cause = seen;
  if (cause == StopCondition::Cause::none) return false;
  next = static_cast<int>(ants.size());
  return true;
}

/// One thread's part of a walk.
class Walkers::Worker {
 public:
  Worker(const Walkers& walkers, ThreadScratch& scratch, int thread, Sending& sending) noexcept
      : walkers_(walkers), scratch_(scratch), thread_(thread), sending_(sending) {}

  /// Sends ants until there are no more, and advances those under way.
  void work() {
    scratch_.done.clear();
    const auto slots =
        std::span(slots_).first(walkers_.slots_for(static_cast<int>(sending_.ants.size())));
    const int count = static_cast<int>(slots.size());
    for (int i = 0; i < count; ++i) send(i);
    while (under_way_ > 0) {
      for (int i = 0; i < count; ++i) {
        if (slots[i].state != WalkState::idle) make_room(i);
      }
      sending_.kernel(sending_.world, slots, kRounds);
      bool cut_short = sending_.cut_short();
      for (int i = 0; i < count; ++i) {
        const WalkState state = slots[i].state;
        if (state == WalkState::idle || (state == WalkState::walking && !cut_short)) continue;
        if (state != WalkState::walking) retire(slots[i]);
        if (!clear(i, cut_short) && !cut_short) cut_short = sending_.cut_short();
        send(i);
      }
    }
  }

 private:
  int number(const WalkSlot& slot) const noexcept {
    return static_cast<int>(slot.ant) - sending_.first;
  }

  void send(int i) {
    const int ant = sending_.next.fetch_add(1, std::memory_order_relaxed);
    if (ant >= static_cast<int>(sending_.ants.size())) return;
    WalkSlot& slot = slots_[i];
    slot.send(sending_.world.start, static_cast<std::uint32_t>(sending_.first + ant));
    slot.visited = VisitedPlane::over(scratch_.slots[i].plane.at(0), walkers_.height_);
    slot.visited.mark(slot.at);
    ++under_way_;
  }

  void make_room(int i) {
    WalkSlot& slot = slots_[i];
    Ant& ant = sending_.ants[number(slot)];
    const auto room = [](auto& buffer, std::int64_t used) {
      const auto needed = static_cast<std::size_t>(used + kRounds + WalkSlot::kMovesBeyond);
      if (buffer.size() < needed) buffer.grow(2 * needed);
      return buffer.data();
    };
    slot.moves = room(ant.moves, slot.move_count);
    slot.dead = room(walkers_.dead_wanted_ ? ant.dead : scratch_.slots[i].dead, slot.dead_count);
  }

  /// Records the tour of an ant that has arrived or is lost.
  void retire(const WalkSlot& slot) {
    const int ant = number(slot);
    Ant& walked = sending_.ants[ant];
    walked.arrived = slot.state == WalkState::arrived;
    walked.move_count = slot.move_count;
    walked.dead_count = walkers_.dead_wanted_ ? slot.dead_count : 0;
    walked.steps = slot.move_count + 2 * slot.dead_count;
    scratch_.done.push_back(ant);
    if (sending_.after.ended) sending_.after.ended(ant, thread_);
  }

  /// Empties a slot; false where its plane stays marked. Only another walk needs a clear one: not
  /// where this one is cut short.
  bool clear(int i, bool cut_short) {
    WalkSlot& slot = slots_[i];
    slot.state = WalkState::idle;
    --under_way_;
    const bool cleared = !cut_short && forget(slot, scratch_.slots[i].plane);
    scratch_.slots[i].marked = !cleared;
    return cleared;
  }

  /// Clears the plane of the cells that an ant entered; false when stopped.
  bool forget(const WalkSlot& slot, ZeroArray<std::uint64_t>& plane) const {
    Poller poller(sending_.stop);
    // Clearing a cell costs about what sixteen words of a whole plane do.
    constexpr std::int64_t kWordsACell = 16;
    if (plane.size() <= kWordsACell * (slot.move_count + slot.dead_count)) {
      return plane.clear(poller);
    }
    PackedCell c = slot.at;
    slot.visited.clear(c);
    for (std::int64_t m = slot.move_count - 1; m >= 0; --m) {
      c -= static_cast<PackedCell>(sending_.world.delta[slot.moves[m]]);
      slot.visited.clear(c);
      if (poller.stop_after(kWordsACell)) return false;
    }
    for (std::int64_t d = 0; d < slot.dead_count; ++d) {
      slot.visited.clear(slot.dead[d]);
      if (poller.stop_after(kWordsACell)) return false;
    }
    return true;
  }

  const Walkers& walkers_;
  ThreadScratch& scratch_;
  int thread_;
  Sending& sending_;
  std::array<WalkSlot, kSlots> slots_;
  int under_way_ = 0;
};

StopCondition::Cause Walkers::walk(const WalkWorld& world, kernels::WalkFn kernel,
                                   std::span<Ant> ants, int first, const StopCondition& stop,
                                   const AfterWalk& after) {
  Sending sending{world, kernel, ants, first, stop, after};
  std::atomic<int> still_walking{threads_};
  try {
    parallel_for(threads_, threads_, [&](int i, int thread) {
      Worker(*this, scratch_[i], thread, sending).work();
      --still_walking;
      if (!after.spare) return;
      for (const int ant : scratch_[i].done) {
        if (still_walking == 0) break;
        after.spare(ant, thread);
      }
    });
  } catch (...) {
    scratch_.clear();  // cells entered are still marked in their planes
    throw;
  }
  return sending.cause;
}

}  // namespace lasius
