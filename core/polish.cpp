#include "polish.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "lasius/path.h"
#include "parallel.h"

namespace lasius {
namespace {

/// The cells of a tour, start first, and those that its moves cross.
void swept_cells(std::span<const std::uint8_t> tour, const kernels::Moves& moves, Cell start,
                 std::vector<Cell>& cells) {
  cells.assign(1, start);
  Cell c = start;
  for (const int k : tour) {
    const kernels::Move& move = moves[k];
    for (int i = 0; i < move.swept_count; ++i) {
      cells.push_back({c.x + move.swept[i].dx, c.y + move.swept[i].dy});
    }
    c = {c.x + move.to.dx, c.y + move.to.dy};
    cells.push_back(c);
  }
}

}  // namespace

void Polisher::reset(const Grid& grid, const Request& request, const kernels::Moves& moves,
                     const Params& params, int threads) {
  grid_ = &grid;
  moves_ = &moves;
  stop_ = &request.stop;
  start_ = request.start;
  polish_ = params.polish;
  corners_ = params.corners;
  threads_ = threads;
  if (static_cast<int>(scratch_.size()) < threads) scratch_.resize(threads);
  paths_.resize(params.ants);
  for (PolishedPath& path : paths_) path.made = false;
}

void Polisher::polish(std::span<const Ant> ants, const std::function<void()>& meanwhile) {
  const auto count = static_cast<int>(ants.size());
  const int threads = polish_ == Polish::none ? 1 : std::clamp(count / 2, 1, threads_);
  parallel_for(count + 1, threads, [&](int i, int thread) {
    if (i == 0) {
      if (meanwhile) meanwhile();
    } else if (PolishedPath& path = paths_[i - 1]; !std::exchange(path.made, false)) {
      make(ants[i - 1], scratch_[thread], path);
    }
  });
}

void Polisher::polish_ahead(std::span<const Ant> ants, int ant, int thread) {
  make(ants[ant], scratch_[thread], paths_[ant]);
  paths_[ant].made = true;
}

void Polisher::make(const Ant& ant, Scratch& scratch, PolishedPath& path) const {
  path.points.clear();
  path.raster.clear();
  path.length = std::numeric_limits<double>::quiet_NaN();
  if (polish_ == Polish::none || !ant.arrived) return;
  if (stop_->poll() != StopCondition::Cause::none) return;

  swept_cells(ant.tour(), *moves_, start_, scratch.tour);
  // Cells that the ant left again may shorten its way, too.
  auto walk = scratch.cutter.cut(*grid_, scratch.tour, moves_->count > 4, corners_, *stop_,
                                 ant.dead_ends());
  if (walk.empty()) walk = scratch.tour;  // stopped
  scratch.straightener.run(*grid_, walk, *stop_);
  if (polish_ == Polish::straight) scratch.straightener.tighten(*grid_, *stop_);
  const auto cells = scratch.straightener.cells();
  path.raster.assign(cells.begin(), cells.end());
  if (polish_ == Polish::taut) {
    scratch.tautener.run(*grid_, scratch.straightener.vertices(), corners_, *stop_);
    const auto points = scratch.tautener.path();
    path.points.assign(points.begin(), points.end());
  } else {
    for (const Cell c : scratch.straightener.vertices()) path.points.push_back(centre(c));
  }
  path.length = path_length(path.points);
}

}  // namespace lasius
