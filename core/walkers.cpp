#include "walkers.h"

#include <algorithm>

#include "parallel.h"

namespace lasius {

using kernels::PackedCell;
using kernels::VisitedPlane;
using kernels::WalkSlot;
using kernels::WalkState;
using kernels::WalkWorld;

void tour_cells(std::span<const std::uint8_t> tour, const kernels::Moves& moves, Cell start,
                bool swept, std::vector<Cell>& cells) {
  cells.assign(1, start);
  Cell c = start;
  for (const int k : tour) {
    const kernels::Move& move = moves[k];
    for (int i = 0; swept && i < move.swept_count; ++i) {
      cells.push_back({c.x + move.swept[i].dx, c.y + move.swept[i].dy});
    }
    c = {c.x + move.to.dx, c.y + move.to.dy};
    cells.push_back(c);
  }
}

void Walkers::reset(int width, int height, int threads, int ants) {
  if (width != width_ || height != height_) teams_.clear();
  width_ = width;
  height_ = height;
  threads_ = std::clamp(ants / 2, 1, threads);  // more would idle
  if (static_cast<int>(teams_.size()) < threads_) teams_.resize(threads_);
  for (Team& team : teams_) {
    team.done.reserve(ants);
    for (int i = 0; i < slots_for(ants); ++i) {
      ZeroArray<std::uint64_t>& plane = team.slots[i].plane;
      if (!plane) plane = ZeroArray<std::uint64_t>(VisitedPlane::words_for(width, height));
    }
  }
}

StopCondition::Cause Walkers::walk(const WalkWorld& world, kernels::WalkFn kernel,
                                   std::span<Ant> ants, int first, const StopCondition& stop,
                                   const WhileOthersWalk& spare) {
  std::atomic<int> next{0};
  std::atomic<int> still_walking{threads_};
  std::atomic<StopCondition::Cause> cause{StopCondition::Cause::none};
  try {
    parallel_for(threads_, threads_, [&](int i, int thread) {
      work(teams_[i], world, kernel, ants, first, next, cause, stop);
      --still_walking;
      if (!spare) return;
      for (const int ant : teams_[i].done) {
        if (still_walking == 0) break;
        spare(ant, thread);
      }
    });
  } catch (...) {
    teams_.clear();  // cells entered are still marked in their planes
    throw;
  }
  return cause;
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

void Walkers::work(Team& team, const WalkWorld& world, kernels::WalkFn kernel, std::span<Ant> ants,
                   int first, std::atomic<int>& next, std::atomic<StopCondition::Cause>& cause,
                   const StopCondition& stop) const {
  const int slot_count = slots_for(static_cast<int>(ants.size()));
  std::array<WalkSlot, kSlots> slots;
  std::array<bool, kSlots> occupied{};
  std::array<int, kSlots> numbers{};  // in `ants`
  int under_way = 0;

  const auto send = [&](int i) {
    const int ant = next.fetch_add(1, std::memory_order_relaxed);
    occupied[i] = ant < static_cast<int>(ants.size());
    if (!occupied[i]) return;
    WalkSlot& slot = slots[i];
    slot.send(world.start, static_cast<std::uint32_t>(first + ant));
    numbers[i] = ant;
    slot.visited = VisitedPlane::over(team.slots[i].plane.at(0), height_);
    slot.visited.mark(slot.at);
    ++under_way;
  };

  const auto make_room = [&](int i) {
    WalkSlot& slot = slots[i];
    const auto room = [](auto& buffer, std::int64_t used) {
      const auto needed = static_cast<std::size_t>(used + kRounds + WalkSlot::kMovesBeyond);
      if (buffer.size() < needed) buffer.resize(2 * needed);
      return buffer.data();
    };
    slot.moves = room(ants[numbers[i]].moves, slot.move_count);
    slot.dead = room(team.slots[i].dead, slot.dead_count);
  };

  // Records the ant's tour.
  const auto retire = [&](int i) {
    WalkSlot& slot = slots[i];
    Ant& ant = ants[numbers[i]];
    ant.arrived = slot.state == WalkState::arrived;
    ant.move_count = slot.move_count;
    ant.steps = slot.move_count + 2 * slot.dead_count;
    forget(slot, team.slots[i].plane.at(0), world);
    ant.dead.assign(slot.dead, slot.dead + slot.dead_count);
    slot.state = WalkState::lost;
    team.done.push_back(numbers[i]);
    --under_way;
  };

  team.done.clear();
  for (int i = 0; i < slot_count; ++i) send(i);
  while (under_way > 0) {
    for (int i = 0; i < slot_count; ++i) {
      if (occupied[i]) make_room(i);
    }
    kernel(world, {slots.data(), static_cast<std::size_t>(slot_count)}, kRounds);
    if (const auto seen = stop.poll(); seen != StopCondition::Cause::none) cause = seen;
    const bool stopped = cause != StopCondition::Cause::none;
    if (stopped) next = static_cast<int>(ants.size());  // nobody sends another
    for (int i = 0; i < slot_count; ++i) {
      if (!occupied[i] || (slots[i].state == WalkState::walking && !stopped)) continue;
      retire(i);
      send(i);
    }
  }
}

}  // namespace lasius
