// How the trail changes after ants have walked: one function a published family.
#pragma once

#include <span>
#include <vector>

#include "field.h"
#include "kernels/moves.h"
#include "lasius/params.h"
#include "walkers.h"

namespace lasius {

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

/// tau0: `initial_pheromone`, or where that is 0 the formula of the update's source with the
/// straight distance from start to goal in place of a first tour's length.
double initial_pheromone(const Params& params, double straight_distance) noexcept;

/// After every batch of ants: the local update (ACS), if there is one.
void update_locally(Field& field, const Params& params, double tau0, const Tours& batch);

/// After every iteration.
void update_trail(Field& field, const Params& params, const Tours& tours);

/// The generation's answer of the terminal index: from the start always to the cell of least
/// K + step, ties to the first move (Li, Wang & Ma, section 2.2). Empty while the start has none.
void best_known_way(Field& field, const kernels::Moves& moves, Cell start, Cell goal,
                    std::vector<std::uint8_t>& way);

/// Calls `visit(cell, move)` along a tour, for every cell that carries pheromone: with arcs the
/// cells that a move leaves, with cells all of them (the last without a move, 0).
template <class Visit>
void along(const Tours& tours, const Tour& tour, Trail trail, const Visit& visit) {
  Cell c = tours.start;
  for (const int k : tour.moves) {
    visit(c, k);
    c = {c.x + tours.moves[k].to.dx, c.y + tours.moves[k].to.dy};
  }
  if (trail == Trail::cells) visit(c, 0);
}

}  // namespace lasius
