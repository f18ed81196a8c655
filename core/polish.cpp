#include "polish.h"

#include <omp.h>

#include <algorithm>
#include <exception>
#include <limits>

#include "lasius/path.h"

namespace lasius {

void Polisher::reset(const Params& params, int threads) {
  polish_ = params.polish;
  corners_ = params.corners;
  threads_ = threads;
  if (static_cast<int>(scratch_.size()) < threads) scratch_.resize(threads);
  paths_.resize(params.ants);
}

void Polisher::polish(const Grid& grid, Cell start, const kernels::Moves& moves,
                      std::span<const Ant> ants, const StopCondition& stop) {
  std::exception_ptr error;
  const int threads = std::clamp(static_cast<int>(ants.size()) / 2, 1, threads_);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (int a = 0; a < static_cast<int>(ants.size()); ++a) {
    try {
      polish_one(grid, start, moves, ants[a], stop, paths_[a]);
    } catch (...) {  // none may leave the parallel region
#pragma omp critical
      error = std::current_exception();
    }
  }
  if (error) std::rethrow_exception(error);
}

void Polisher::polish_one(const Grid& grid, Cell start, const kernels::Moves& moves, const Ant& ant,
                          const StopCondition& stop, PolishedPath& path) {
  path.points.clear();
  path.raster.clear();
  path.length = std::numeric_limits<double>::quiet_NaN();
  if (!ant.arrived) return;

  Scratch& scratch = scratch_[omp_get_thread_num()];
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
