#include "polish.h"

#include <algorithm>
#include <limits>

#include "lasius/path.h"
#include "parallel.h"

namespace lasius {

void Polisher::reset(const Params& params, int threads) {
  polish_ = params.polish;
  corners_ = params.corners;
  threads_ = threads;
  if (static_cast<int>(scratch_.size()) < threads) scratch_.resize(threads);
  paths_.resize(params.ants);
}

void Polisher::polish(const Grid& grid, Cell start, const kernels::Moves& moves,
                      std::span<const Ant> ants, const StopCondition& stop,
                      const std::function<void()>& meanwhile) {
  const auto count = static_cast<int>(ants.size());
  parallel_for(count + 1, std::clamp(count / 2, 1, threads_), [&](int i, int thread) {
    if (i > 0) {
      const int a = i - 1;
      polish_one(grid, start, moves, ants[a], stop, scratch_[thread], paths_[a]);
    } else if (meanwhile) {
      meanwhile();
    }
  });
}

void Polisher::polish_one(const Grid& grid, Cell start, const kernels::Moves& moves, const Ant& ant,
                          const StopCondition& stop, Scratch& scratch, PolishedPath& path) {
  path.points.clear();
  path.raster.clear();
  path.length = std::numeric_limits<double>::quiet_NaN();
  if (!ant.arrived) return;

  const bool straight = polish_ != Polish::none && stop.poll() == StopCondition::Cause::none;
  tour_cells(ant.tour(), moves, start, straight, scratch.tour);
  std::span<const Cell> vertices = scratch.tour;
  if (straight) {
    // Cells that the ant left again may shorten its way, too.
    const std::size_t tour_size = scratch.tour.size();
    const Cell goal = scratch.tour.back();
    for (const auto c : ant.dead)
      scratch.tour.push_back({kernels::packed_x(c), kernels::packed_y(c)});
    scratch.tour.push_back(goal);
    auto walk = scratch.cutter.cut(grid, scratch.tour, moves.count > 4, corners_, stop);
    scratch.tour.resize(tour_size);
    if (walk.empty()) walk = scratch.tour;  // stopped
    scratch.straightener.run(grid, walk, stop);
    if (polish_ == Polish::straight) scratch.straightener.tighten(grid, stop);
    vertices = scratch.straightener.vertices();
    const auto cells = scratch.straightener.cells();
    path.raster.assign(cells.begin(), cells.end());
  }
  if (polish_ == Polish::taut) {
    scratch.tautener.run(grid, vertices, corners_, stop);
    const auto points = scratch.tautener.path();
    path.points.assign(points.begin(), points.end());
  } else {
    for (const Cell c : vertices) path.points.push_back(centre(c));
  }
  path.length = path_length(path.points);
}

}  // namespace lasius
