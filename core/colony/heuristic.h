// The part of a move's weight that the pheromone has no say in.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/cost/terrain.h"
#include "kernels/base/moves.h"
#include "kernels/base/raise.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"

namespace lasius {

/// Which moves exist from a cell, and how good each looks.
class HeuristicRows {
 public:
  /// The least value of a move that exists, the largest of its row being 1.
  static constexpr double kSmallest = 0x1p-60;

  /// `grid` must outlive the object's use, and so must `own`, an OwnRules::heuristic that takes the
  /// place of the parameters' one, or empty. Over a terrain the parameters' one has the factor
  /// least weight / weight of the cell that a move leads to. Heuristic::distance_field works
  /// through the whole map, and stops early (with the parts not yet reached at distance 0) when
  /// told to.
  void reset(const Grid& grid, const kernels::Moves& moves, Cell goal, const Params& params,
             const StopCondition& stop, std::span<const double> own = {},
             const cost::Terrain* terrain = nullptr);

  /// Writes one value a move: 0 where a move does not exist, else in [kSmallest, 1], scaled so that
  /// the row's largest is 1. A blocked cell has no moves.
  void fill(Cell c, double beta, float* row) const;

  /// True when `fill` depends on beta.
  bool depends_on_beta() const noexcept {
    return !own_.empty() || terrain_ != nullptr ||
           (params_.heuristic != Heuristic::uniform &&
            params_.heuristic != Heuristic::rescaled_distance &&
            params_.heuristic != Heuristic::learned);
  }

  std::int64_t bytes() const noexcept { return distances_.bytes(); }  ///< memory held

 private:
  /// What is raised to beta, or to lambda with Heuristic::rescaled_distance.
  double base(Cell c, Cell to, double farthest) const noexcept;
  double ease(Cell to) const noexcept;  ///< what a terrain makes of it, up to 1
  double own(Cell c, int move) const noexcept;
  bool rescaled() const noexcept {
    return own_.empty() && params_.heuristic == Heuristic::rescaled_distance;
  }
  void measure_distances(Poller& poller);

  const Grid* grid_ = nullptr;
  kernels::Moves moves_;
  Cell goal_;
  Params params_;
  kernels::RaiseFn raise_ = nullptr;
  ZeroArray<float> distances_;  // Heuristic::distance_field: of each cell, row-major; 0: not known
  std::span<const double> own_;
  const cost::Terrain* terrain_ = nullptr;
  std::int64_t cells_ = 0;  // of the grid
};

}  // namespace lasius
