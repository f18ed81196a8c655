#include "core/arm/lattice_ants.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "kernels/base/proportional.h"
#include "kernels/base/random_stream.h"

namespace lasius::arm {

/// An ant's random stream, by a name of its own so that the header needs no Random123.
class Dice : public kernels::RandomStream {
 public:
  using RandomStream::RandomStream;
};

LatticeAnts::LatticeAnts(Lattice& lattice, const LatticeTrail& trail, const Params& parameters)
    : lattice_(lattice), trail_(trail), parameters_(parameters) {
  const int threads = std::clamp(parameters.ants / 2, 1, std::max(parameters.threads, 1));
  for (int i = 0; i < threads; ++i)
    scratch_.push_back({ZeroArray<std::uint8_t>(lattice.nodes()), {}, {}});
}

StopCondition::Cause LatticeAnts::walk(int iteration, std::span<LatticeAnt> ants,
                                       const StopCondition& stop) {
  std::atomic<StopCondition::Cause> cause{StopCondition::Cause::none};
  const auto count = static_cast<int>(ants.size());
  parallel_for(count, static_cast<int>(scratch_.size()), [&](int a, int thread) {
    ants[a].arrived = false;
    ants[a].moves.clear();
    ants[a].steps = 0;
    if (cause != StopCondition::Cause::none) return;
    const auto seen = walk_one(scratch_[thread], iteration, a, ants[a], stop);
    if (seen != StopCondition::Cause::none) cause = seen;
  });
  return cause;
}

/// The random proportional rule (eq. 3, 9) over the points not yet visited that can be reached: a
/// move that turns out closed is drawn again without it, which leaves the others in proportion. -1
/// when there is none, or when stopped.
int LatticeAnts::draw_open_move(const ThreadScratch& scratch, Node at, Dice& dice,
                                LatticePoller& poller) const {
  std::array<double, kMostMoves> weights;
  const std::span weight(weights.data(), static_cast<std::size_t>(lattice_.moves()));
  const float* guidance = lattice_.guidance(at);
  for (int k = 0; k < lattice_.moves(); ++k) {
    const bool closed = !(guidance[k] > 0) || scratch.visited[lattice_.to(at, k)] != 0;
    weight[k] = closed ? 0 : trail_.attraction(trail_.place(at, k)) * guidance[k];
  }
  for (;;) {
    const int move = kernels::proportional_choice(weight, 0, dice.next());
    if (move < 0 || lattice_.open(at, move)) return move;
    if (poller.stop_after(0)) return -1;
    weight[move] = 0;
  }
}

StopCondition::Cause LatticeAnts::walk_one(ThreadScratch& scratch, int iteration, int number,
                                           LatticeAnt& ant, const StopCondition& stop) const {
  constexpr int kSteps = 256;  // between two polls: kinematics takes its time
  static_assert(kSteps <= Poller::kSteps);
  // Many ants of few steps each would never spend the poller's budget.
  if (const auto cause = stop.poll(); cause != StopCondition::Cause::none) return cause;
  Dice dice(parameters_.seed, static_cast<std::uint32_t>(number),
            static_cast<std::uint32_t>(iteration));
  LatticePoller poller(lattice_, stop, kSteps);
  Node at = lattice_.start();
  scratch.visited[at] = 1;
  scratch.entered.assign(1, at);
  scratch.way.assign(1, at);
  struct Forget {
    ThreadScratch& scratch;
    ~Forget() {
      for (const Node v : scratch.entered) scratch.visited[v] = 0;
    }
  } forget{scratch};

  while (!lattice_.arrived(at)) {
    if (poller.stop_after(1)) return poller.cause();
    ++ant.steps;
    const int move = draw_open_move(scratch, at, dice, poller);
    if (poller.stopped()) return poller.cause();
    if (move >= 0) {
      at = lattice_.to(at, move);
      ant.moves.push_back(static_cast<std::uint8_t>(move));
      scratch.visited[at] = 1;
      scratch.entered.push_back(at);
      scratch.way.push_back(at);
    } else if (ant.moves.empty() || parameters_.dead_end == DeadEnd::kill) {
      return StopCondition::Cause::none;  // lost
    } else {
      scratch.way.pop_back();
      at = scratch.way.back();
      ant.moves.pop_back();
    }
  }
  ant.arrived = true;
  return StopCondition::Cause::none;
}

}  // namespace lasius::arm
