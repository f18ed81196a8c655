// From ants' tours to paths: straightened, taut, or as they are.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "kernels/walk.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/params.h"
#include "lasius/stop.h"
#include "loop_cutter.h"
#include "straighten.h"
#include "tauten.h"
#include "walkers.h"

namespace lasius {

/// One ant's path after polishing. A cache line of its own: threads polish neighbours.
struct alignas(64) PolishedPath {
  double length = 0;          // NaN where the ant did not arrive: never less than any other
  std::vector<Point> points;  // the polyline
  std::vector<Cell> raster;   // the cells under it; empty without polish
};

/// Polishes the tours of one iteration, over threads.
class Polisher {
 public:
  void reset(const Params& params, int threads);

  /// Makes the path of every ant that arrived. When stopped, rougher but valid paths. One of the
  /// threads does what is to be done `meanwhile`, if anything.
  void polish(const Grid& grid, Cell start, const kernels::Moves& moves, std::span<const Ant> ants,
              const StopCondition& stop, const std::function<void()>& meanwhile);

  /// By ant.
  std::span<const PolishedPath> paths() const noexcept { return paths_; }

 private:
  struct alignas(64) Scratch {  // of one thread
    std::vector<Cell> tour;
    LoopCutter cutter;
    Straightener straightener;
    Tautener tautener;
  };
  void polish_one(const Grid& grid, Cell start, const kernels::Moves& moves, const Ant& ant,
                  const StopCondition& stop, Scratch& scratch, PolishedPath& path);

  Polish polish_ = Polish::none;
  Corners corners_ = Corners::forbid;
  int threads_ = 1;
  std::vector<Scratch> scratch_;
  std::vector<PolishedPath> paths_;
};

}  // namespace lasius
