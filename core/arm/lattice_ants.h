// Ants in the lattice: one iteration's walks, over threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/arm/lattice.h"
#include "core/arm/lattice_trail.h"
#include "lasius/base/stop.h"

namespace lasius::arm {

/// One ant's walk. A cache line of its own: neighbours are walked by different threads.
struct alignas(64) LatticeAnt {
  bool arrived = false;
  std::vector<std::uint8_t> moves;  // of the tour, what was taken back left out
  std::int64_t steps = 0;           // moves made, those taken back twice
};

class LatticeAnts {
 public:
  LatticeAnts(Lattice& lattice, const LatticeTrail& trail, const Params& parameters);

  /// Walks every ant until it has arrived, is lost, or `stop` says so; then ants under way are
  /// lost. Which thread walks which ant changes nothing.
  StopCondition::Cause walk(int iteration, std::span<LatticeAnt> ants, const StopCondition& stop);

 private:
  /// Of one thread, for the ant that it walks.
  struct alignas(64) ThreadScratch {
    ZeroArray<std::uint8_t> visited;  // by node, 1: visited
    std::vector<Node> entered;        // nodes to clear in `visited`
    std::vector<Node> way;            // from the start to the ant
  };

  StopCondition::Cause walk_one(ThreadScratch& scratch, int iteration, int number, LatticeAnt& ant,
                                const StopCondition& stop) const;
  int draw_open_move(const ThreadScratch& scratch, Node at, class Dice& dice,
                     LatticePoller& poller) const;

  Lattice& lattice_;
  const LatticeTrail& trail_;
  const Params& parameters_;
  std::vector<ThreadScratch> scratch_;
};

}  // namespace lasius::arm
