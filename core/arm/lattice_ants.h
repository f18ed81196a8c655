// Ants in the lattice: one iteration's walks, over threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/arm/lattice.h"
#include "core/arm/lattice_trail.h"
#include "lasius/stop.h"

namespace lasius::arm {

/// One ant's walk. A cache line of its own: neighbours are walked by different threads.
struct alignas(64) LatticeAnt {
  bool arrived = false;
  bool tired = false;               // it took as many steps as it may
  std::vector<std::uint8_t> moves;  // of the tour, what was taken back left out
  std::int64_t steps = 0;           // moves made, those taken back twice
};

class LatticeAnts {
 public:
  LatticeAnts(const Lattice& lattice, const LatticeTrail& trail, const Params& parameters);

  /// Walks every ant until it has arrived, is lost, or `stop` says so; then ants under way are
  /// lost. Which thread walks which ant changes nothing.
  /// The first ant sets out along `scouted`, moves from the start, as far as they are open.
  StopCondition::Cause walk(int iteration, std::span<LatticeAnt> ants, const StopCondition& stop,
                            std::span<const int> scouted = {});
  /// Ants may take so many steps from now on; 0: any number.
  void set_leash(std::int64_t steps) noexcept { leash_ = steps; }

 private:
  /// What one thread needs, apart from the others': the points that its ant has visited, a byte
  /// each.
  struct alignas(64) Team {
    ZeroArray<std::uint8_t> visited;
    std::vector<Node> entered;  // to clear it by
    std::vector<Node> way;      // from the start to where it is
  };

  StopCondition::Cause walk_one(Team& team, int iteration, int number, LatticeAnt& ant,
                                const StopCondition& stop, std::span<const int> scouted) const;
  int draw_open_move(const Team& team, Node at, class Dice& dice, LatticePoller& poller) const;

  const Lattice& lattice_;
  const LatticeTrail& trail_;
  const Params& parameters_;
  std::vector<Team> teams_;
  std::int64_t leash_ = 0;
};

}  // namespace lasius::arm
