// Pheromone and weight rows of one colony, kept in tiles that exist only where ants have been.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "kernels/walk.h"
#include "lasius/grid.h"
#include "lasius/params.h"
#include "schedule.h"

namespace lasius {

/// tau of every cell or arc, and from it the rows that ants draw from.
///
/// A row's weights are products of A = (tau / largest tau of the row)^alpha and the heuristic B,
/// also scaled to a largest value of 1: a draw only sees ratios. Both are at least 2^-60 for a move
/// that exists and 0 for one that does not, so the static part of the feasible neighbourhood needs
/// no mask of its own.
///
/// Evaporation multiplies one number, `scale_`: stored values are tau / scale. It cancels in every
/// row, so only rows next to a deposit are computed again, and a cell that no ant touched costs
/// nothing. Where alpha or beta change, so are the rows next to any deposit there ever was.
class Field {
 public:
  Field();
  ~Field();

  /// Forgets everything and gets ready for one plan. Tiles are kept for reuse.
  /// `moves` and `goal` shape the rows; `grid` must outlive the field's use.
  void reset(const Grid& grid, const kernels::Moves& moves, Cell goal, const Params& params);

  /// Brings all rows up to date with the deposits so far and this iteration's exponents.
  void refresh(const StepWeights& weights, int threads);

  /// Completes what a walk reads: tiles and how to make one.
  void fill(kernels::WalkWorld& world);

  /// tau <- persistence * tau everywhere.
  void evaporate(double persistence);

  /// tau += amount on a cell (Trail::cells) or on the move `move` out of it (Trail::arcs).
  void deposit(Cell c, int move, double amount);

  /// Rows hold a part for pheromone and one for distance, for a mixture of rules.
  bool mixture() const noexcept { return mixture_; }

  double pheromone(Cell c) const;  ///< tau of a cell; with arcs, the largest of its moves

  std::int64_t bytes() const noexcept;  ///< memory held
  int tiles() const noexcept { return static_cast<int>(used_.size()); }

 private:
  struct Tile;

  Tile* find(int x, int y) const noexcept;
  Tile& obtain(int index);
  static float* make_tile(void* field, int index);
  void fill_heuristic(Tile& tile) const;
  void fill_row(Tile& tile, int x, int y) const;
  void refresh_tile(Tile& tile, bool touched, bool all) const;
  float stored(int x, int y) const noexcept;

  const Grid* grid_ = nullptr;
  kernels::Moves moves_;
  Params params_;
  Cell goal_;
  int lanes_ = 8;
  bool mixture_ = false;
  StepWeights weights_;

  int tiles_x_ = 0;
  int tiles_y_ = 0;
  std::vector<float*> rows_;                 // by tile, what walks read; null where there is none
  std::vector<Tile*> directory_;             // by tile
  std::vector<std::unique_ptr<Tile>> pool_;  // every tile ever made
  std::vector<Tile*> unused_;
  std::vector<Tile*> used_;
  std::mutex making_;

  double scale_ = 1;     // tau = stored value * scale_
  float untouched_ = 1;  // stored value where nothing was ever deposited
};

}  // namespace lasius
