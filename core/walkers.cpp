#include "walkers.h"

#include <algorithm>

#include "parallel.h"

namespace lasius {

using kernels::PackedCell;
using kernels::VisitedPlane;
using kernels::WalkSlot;
using kernels::WalkState;
using kernels::WalkWorld;

void Walkers::reset(int width, int height, int threads, int ants, bool dead_wanted) {
  if (width != width_ || height != height_) teams_.clear();
  dead_wanted_ = dead_wanted;
  width_ = width;
  height_ = height;
  threads_ = std::clamp(ants / 2, 1, threads);  // more would idle
  if (static_cast<int>(teams_.size()) < threads_) teams_.resize(threads_);
  for (Team& team : teams_) {
    team.done.reserve(ants);
    for (int i = 0; i < slots_for(ants); ++i) {
      Slot& slot = team.slots[i];
      if (slot.plane && !slot.marked) continue;
      slot.plane = ZeroArray<std::uint64_t>(VisitedPlane::words_for(width, height));
      slot.marked = false;
    }
  }
}

StopCondition::Cause Walkers::walk(const WalkWorld& world, kernels::WalkFn kernel,
                                   std::span<Ant> ants, int first, const StopCondition& stop,
                                   const AfterWalk& after) {
  Sending sending{world, kernel, ants, first, stop, after};
  std::atomic<int> still_walking{threads_};
  try {
    parallel_for(threads_, threads_, [&](int i, int thread) {
      work(teams_[i], thread, sending);
      --still_walking;
      if (!after.spare) return;
      for (const int ant : teams_[i].done) {
        if (still_walking == 0) break;
        after.spare(ant, thread);
      }
    });
  } catch (...) {
    teams_.clear();  // cells entered are still marked in their planes
    throw;
  }
  return sending.cause;
}

bool Walkers::Sending::cut_short() noexcept {
  if (const auto seen = stop.poll(); seen != StopCondition::Cause::none) cause = seen;
  if (cause == StopCondition::Cause::none) return false;
  next = static_cast<int>(ants.size());
  return true;
}

void Walkers::forget(const WalkSlot& slot, std::uint64_t* plane, const WalkWorld& world) const {
  // Clearing a cell costs about what sixteen words of a whole plane do.
  const auto words = VisitedPlane::words_for(width_, height_);
  if (words <= 16 * (slot.move_count + slot.dead_count)) {
    std::fill_n(plane, words, 0);
    return;
  }
  PackedCell c = slot.at;
  slot.visited.clear(c);
  for (std::int64_t m = slot.move_count - 1; m >= 0; --m) {
    c -= static_cast<PackedCell>(world.delta[slot.moves[m]]);
    slot.visited.clear(c);
  }
  for (std::int64_t d = 0; d < slot.dead_count; ++d) slot.visited.clear(slot.dead[d]);
}

void Walkers::work(Team& team, int thread, Sending& sending) const {
  const WalkWorld& world = sending.world;
  const std::span<Ant> ants = sending.ants;
  const int slot_count = slots_for(static_cast<int>(ants.size()));
  std::array<WalkSlot, kSlots> slots;
  std::array<bool, kSlots> occupied{};
  std::array<int, kSlots> numbers{};  // in `ants`
  int under_way = 0;

  const auto send = [&](int i) {
    const int ant = sending.next.fetch_add(1, std::memory_order_relaxed);
    occupied[i] = ant < static_cast<int>(ants.size());
    if (!occupied[i]) return;
    WalkSlot& slot = slots[i];
    slot.send(world.start, static_cast<std::uint32_t>(sending.first + ant));
    numbers[i] = ant;
    slot.visited = VisitedPlane::over(team.slots[i].plane.at(0), height_);
    slot.visited.mark(slot.at);
    ++under_way;
  };

  const auto make_room = [&](int i) {
    WalkSlot& slot = slots[i];
    Ant& ant = ants[numbers[i]];
    const auto room = [](auto& buffer, std::int64_t used) {
      const auto needed = static_cast<std::size_t>(used + kRounds + WalkSlot::kMovesBeyond);
      if (buffer.size() < needed) buffer.grow(2 * needed);
      return buffer.data();
    };
    slot.moves = room(ant.moves, slot.move_count);
    slot.dead = room(dead_wanted_ ? ant.dead : team.slots[i].dead, slot.dead_count);
  };

  // Returns what it went over. Only another walk needs that: not where this one is cut short.
  const auto clear = [&](int i, bool cut_short) {
    const WalkSlot& slot = slots[i];
    --under_way;
    team.slots[i].marked = cut_short;
    if (cut_short) return std::int64_t{0};
    forget(slot, team.slots[i].plane.at(0), world);
    return slot.move_count + slot.dead_count;
  };

  // Records the ant's tour.
  const auto retire = [&](int i) {
    WalkSlot& slot = slots[i];
    Ant& ant = ants[numbers[i]];
    ant.arrived = slot.state == WalkState::arrived;
    ant.move_count = slot.move_count;
    ant.dead_count = dead_wanted_ ? slot.dead_count : 0;
    ant.steps = slot.move_count + 2 * slot.dead_count;
    slot.state = WalkState::lost;
    team.done.push_back(numbers[i]);
    if (sending.after.ended) sending.after.ended(numbers[i], thread);
  };

  team.done.clear();
  for (int i = 0; i < slot_count; ++i) send(i);
  while (under_way > 0) {
    for (int i = 0; i < slot_count; ++i) {
      if (occupied[i]) make_room(i);
    }
    sending.kernel(world, {slots.data(), static_cast<std::size_t>(slot_count)}, kRounds);
    bool cut_short = sending.cut_short();
    for (int i = 0; i < slot_count; ++i) {
      const bool walking = slots[i].state == WalkState::walking;
      if (!occupied[i] || (walking && !cut_short)) continue;
      if (!walking) retire(i);
      if (clear(i, cut_short) > Poller::kWords) cut_short = sending.cut_short();
      send(i);
    }
  }
}

}  // namespace lasius
