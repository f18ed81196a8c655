// What ants read and leave, for formulas with numbers worked by hand.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "core/colony/field.h"
#include "core/colony/update.h"
#include "core/grid/move_rule.h"

namespace lasius {

/// Moves of eight.
inline constexpr std::uint8_t kNorthEast = 2, kWest = 3, kEast = 4, kSouthEast = 7;

/// The row of a cell as ants see it.
inline const float* row(Field& field, Cell c, int floats) {
  kernels::WalkWorld world;
  field.fill(world);
  const int tile = (c.y / kernels::kTileSide) * world.tiles_x + c.x / kernels::kTileSide;
  const float* rows = world.tiles[tile];
  if (rows == nullptr) rows = world.make_tile(world.context, tile);
  return rows +
         ((c.y % kernels::kTileSide) * kernels::kTileSide + c.x % kernels::kTileSide) * floats;
}

/// All rows towards a goal, before anything was learned.
struct Rows {
  Rows(const Grid& grid, Cell goal, const Params& p) : params(p) {
    moves = moves_of(p.neighbours);
    field.reset(grid, moves, goal, p, p.initial_pheromone > 0 ? p.initial_pheromone : 1, {});
  }
  const float* of(Cell c) { return row(field, c, moves.count * (field.mixture() ? 2 : 1)); }
  Params params;
  kernels::Moves moves;
  Field field;
};

/// Ants that walked as told, from (2, 2) on a free 20 x 20 grid, and what an update makes of it.
struct WalkedGrid {
  explicit WalkedGrid(Params p, double tau0 = 1, int size = 20, Cell from = {2, 2},
                      Cell to = {10, 2})
      : grid(size, size), start(from), goal(to), params(std::move(p)), rows(grid, goal, params) {
    rows.field.reset(grid, rows.moves, goal, params, tau0, {});
  }
  void walk(std::vector<std::uint8_t> moves, bool arrived = true) {
    walked.push_back(std::move(moves));
    double length = 0;
    for (const int k : walked.back()) length += rows.moves[k].length;
    lengths.push_back(arrived ? length : std::nan(""));
  }
  void update(int best_so_far = -1, int iteration = 0) {
    std::vector<Tour> ants;
    for (std::size_t a = 0; a < walked.size(); ++a) ants.push_back({walked[a], lengths[a]});
    std::vector<int> ranking;
    const Tour none{{}, std::nan("")};
    update_trail(rows.field, params,
                 {.start = start,
                  .moves = rows.moves,
                  .ants = ants,
                  .best_so_far = best_so_far < 0 ? none : ants[best_so_far],
                  .iteration = iteration,
                  .rows = grid.height(),
                  .ranking = ranking});
  }
  double tau(int x, int y, int move = 0) const { return rows.field.tau({x, y}, move); }

  Grid grid;
  Cell start, goal;
  Params params;
  Rows rows;
  std::vector<std::vector<std::uint8_t>> walked;
  std::vector<double> lengths;
};

}  // namespace lasius
