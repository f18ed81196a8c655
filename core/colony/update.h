// How the trail of a grid changes after ants have walked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/colony/field.h"
#include "core/colony/walkers.h"
#include "core/grid/move_rule.h"
#include "kernels/base/moves.h"
#include "lasius/params/params.h"

namespace lasius {

struct PolishedPath;

/// The tour of one ant as the updates see it.
struct Tour {
  std::span<const std::uint8_t> moves;
  double length = 0;  ///< NaN unless it reached the goal
};

/// What an iteration left behind.
struct Tours {
  Cell start;
  const kernels::Moves& moves;
  std::span<const Tour> ants;  ///< in the order of the ants
  Tour best_so_far;            ///< no moves before an ant has arrived
  int iteration = 0;
  int rows = 0;               ///< height of the map
  std::vector<int>& ranking;  ///< scratch: ants by length of their tours
};

/// Tours of a grid as the rules of a trail see them.
struct GridTours : Tours {
  Trail trail;

  /// With arcs, visits the cells that moves leave, with cells all of them.
  template <class Visit>
  void along(const Tour& tour, const Visit& visit) const {
    Cell c = start;
    for (const int k : tour.moves) {
      visit(GridPlace{c, trail == Trail::arcs ? k : 0});
      c = c + moves[k].to;
    }
    if (trail == Trail::cells) visit(GridPlace{c});
  }
  int choices() const { return moves.count; }
  std::size_t moves_of(const Tour& tour) const { return tour.moves.size(); }
};

/// tau0: `initial_pheromone`, or where that is 0 the formula of the update's source with the
/// straight distance from start to goal in place of a first tour's length.
double initial_pheromone(const Params& params, double straight_distance) noexcept;

/// What tau was at a place.
struct EarlierTau {
  GridPlace place;
  double tau;
};

/// After every batch of ants: the local update (ACS), if there is one. Enters in `before`, unless
/// that is null, what it changes.
void update_locally(Field& field, const Params& params, double tau0, const Tours& batch,
                    std::vector<EarlierTau>* before);

/// After every iteration. Work grows with the moves of its tours and of the best one.
void update_trail(Field& field, const Params& params, const Tours& tours);

/// After every iteration: Q / L on the cells under straightened paths (Fan et al. 2004, step 3), of
/// all ants or of `finder` alone, -1 being none.
void lay_straight_paths(Field& field, const Params& params, std::span<const Ant> ants,
                        std::span<const PolishedPath> paths, int finder);

/// How open the trail leaves the choice along a tour; see Convergence::trail_entropy.
double trail_entropy(Field& field, Trail trail, const kernels::Moves& moves, Cell start,
                     std::span<const std::uint8_t> tour);

}  // namespace lasius
