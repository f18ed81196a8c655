// Pheromone and weight rows of one colony, kept in tiles that exist only where ants have been.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/base/large_array.h"
#include "core/colony/heuristic.h"
#include "kernels/base/raise.h"
#include "kernels/walk/walk.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"
#include "lasius/params/schedule.h"

namespace lasius {

/// What carries pheromone on a grid: with arcs a move out of a cell, with cells the cell itself.
struct GridPlace {
  Cell cell;
  int move = 0;
};

/// tau of every cell or arc, and from it the rows that ants draw from.
///
/// A row's weights are products of A = (tau / largest tau of the row)^alpha and the heuristic B,
/// whose largest value is 1 too: a draw only sees ratios. Both are at least 2^-60 for a move that
/// exists and 0 for one that does not, so the feasible neighbourhood needs no mask but the tabu.
///
/// Evaporation multiplies one number, `scale_`: stored values are tau / scale. It cancels in every
/// row, so only rows next to a change are computed again, and a cell that no ant touched costs
/// nothing. Where rewards make a stored value too large, `scale_` takes a power of two from all of
/// them; beyond a scale of 2^800 it is dropped, since draws see only ratios. Where alpha or beta
/// change, so are the rows next to any change there ever was.
class Field {
 public:
  Field();
  ~Field();

  /// Forgets everything and gets ready for one plan; tau is `untouched` everywhere, eta 1. Tiles
  /// are kept for reuse. `grid` must outlive the field's use, and so must `heuristic`, see
  /// HeuristicRows. What makes rows of all tiles is cut short by `stop`, this function too; then
  /// only another reset makes the field whole again. What changes pheromone never is.
  void reset(const Grid& grid, const kernels::Moves& moves, Cell goal, const Params& params,
             double untouched, const StopCondition& stop, std::span<const double> heuristic = {},
             const cost::Terrain* terrain = nullptr);

  /// Cells of `part` were blocked or freed: moves into, past and out of them exist as the grid has
  /// it. Pheromone stays. Works through the whole map with Heuristic::distance_field.
  void edited(const Rectangle& part);

  /// tau <- (1 - g) tau + g level beside `part`, where tiles are: g falls from `share` on its cells
  /// to 0 at `radius` cells from them.
  void equalise(const Rectangle& part, double radius, double share, double level);

  /// Brings all rows up to date with the changes so far and this iteration's exponents.
  void refresh(const StepWeights& weights, int threads);

  /// Completes what a walk reads: tiles and how to make one. Once the stop condition holds, no more
  /// are made: a walk that comes to one finds every cell blocked.
  void fill(kernels::WalkWorld& world);

  /// Rows hold a part for pheromone and one for distance, for a mixture of rules.
  bool mixture() const noexcept { return mixture_; }

  /// tau <- persistence * tau everywhere, 2^-60 tau at least.
  void evaporate(double persistence);

  /// tau is read as at least `least` and at most `most` from now on.
  void bound(double least, double most) noexcept;

  /// tau of a cell (Trail::cells), or of the move `move` out of it (Trail::arcs).
  double tau(Cell c, int move) const;
  void set_tau(Cell c, int move, double value);
  void deposit(Cell c, int move, double amount);

  // The same by place, as the rules of a trail name them.
  double tau(GridPlace p) const { return tau(p.cell, p.move); }
  void set_tau(GridPlace p, double value) { set_tau(p.cell, p.move, value); }
  void deposit(GridPlace p, double amount) { deposit(p.cell, p.move, amount); }

  /// Raises tau where it was never changed, and the rows next to it. `value` is above the old one.
  void raise_untouched(double value);
  double untouched() const noexcept { return untouched_ * scale_; }

  double scale() const noexcept { return scale_; }  ///< of stored values
  double least() const noexcept { return least_; }  ///< as bound() has it
  double most() const noexcept { return most_; }    ///< as bound() has it
  /// Stored tau of a tile, 0 <= number < tiles(), row-major by cell; `first` is its top left one.
  std::span<const float> stored(int number, Cell& first) const noexcept;

  /// tau of a cell is again what it is where nothing was ever changed.
  void forget(Cell c);

  /// True when the move leads somewhere.
  bool exists(Cell c, int move);

  /// What a cell has taught the ants (Heuristic::learned); 1 at first.
  double eta(Cell c) const;
  void set_eta(Cell c, double value);

  /// tau of a cell; with arcs, the largest of its moves.
  double pheromone(Cell c) const;

  std::int64_t bytes() const noexcept;  ///< memory held
  int tiles() const noexcept { return static_cast<int>(used_.size()); }

 private:
  struct Tile;

  Tile* find(Cell c) const noexcept;
  Tile& obtain(int index);
  Tile& touch(Cell c);
  static float* make_tile(void* field, int index);
  float* blocked_tile(int index);
  std::size_t row_floats() const noexcept {
    return static_cast<std::size_t>(mixture_ ? 2 * moves_.count : moves_.count);
  }
  void lay_out(Tile& tile) const;
  int taus() const noexcept { return params_.trail == Trail::arcs ? moves_.count : 1; }
  void fill_heuristic(Tile& tile) const;
  void fill_every_row(Tile& tile) const;
  void fill_rows(Tile& tile, std::span<const std::uint16_t> cells) const;
  template <class Count>
  void fill_rows_of(Tile& tile, std::span<const std::uint16_t> cells, Count moves) const;
  template <class Count>
  void read_trail(const Tile& tile, int cell, Count moves, float* tau, float* eta) const;
  template <class Count>
  void read_index(const Tile& tile, int cell, Count moves, double* index) const;
  void refresh_tile(Tile& tile, bool touched) const;
  void store(float& stored, double value);
  void keep_scale_in_range();
  void shrink_stored();
  void set_scale(double scale) noexcept {
    scale_ = scale;
    per_scale_ = 1 / scale;
  }
  int index_of(Cell c) const noexcept {
    return (c.y >> kernels::kTileShift) * tiles_x_ + (c.x >> kernels::kTileShift);
  }

  /// Calls action(tile) for all tiles, on up to `threads` threads; for fewer when stopped.
  template <class Action>
  void for_all_tiles(int threads, const StopCondition& stop, const Action& action);

  const Grid* grid_ = nullptr;
  StopCondition stop_;
  kernels::Moves moves_;
  Cell goal_;
  Params params_;
  HeuristicRows heuristic_;
  kernels::RaiseFn raise_ = nullptr;
  bool mixture_ = false;
  bool learned_ = false;
  int reach_ = 1;  // cells that a move goes at most
  StepWeights weights_;

  int tiles_x_ = 0;
  ZeroArray<float*> rows_;                   // by tile, what walks read; null where there is none
  ZeroArray<Tile*> directory_;               // by tile
  ZeroArray<float> blocked_rows_;            // of a tile that was not made
  std::vector<int> not_made_;                // such tiles, by index
  std::vector<std::unique_ptr<Tile>> pool_;  // every tile ever made
  std::vector<Tile*> unused_;
  std::vector<Tile*> used_;
  std::mutex making_;

  double scale_ = 1;        // tau = stored value * scale_
  double per_scale_ = 1;    // 1 / scale_
  float untouched_ = 1;     // stored value where nothing was ever changed
  bool all_stale_ = false;  // every row is to be made again
  double least_ = 0;        // bounds on tau
  double most_ = 0;
  bool was_bounded_ = false;  // when rows were last made
};

}  // namespace lasius
