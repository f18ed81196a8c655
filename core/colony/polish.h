// From ants' tours to paths: straightened, taut, or as they are.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/large_array.h"
#include "core/base/special_values.h"
#include "core/colony/tour_measures.h"
#include "core/colony/walkers.h"
#include "core/smooth/path_maker.h"
#include "kernels/walk/walk.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"
#include "lasius/plan/request.h"

namespace lasius {

/// One ant's path after polishing. A cache line of its own: threads polish neighbours.
struct alignas(64) PolishedPath {
  double length = 0;          // or cost; NaN where there is none: never less than any other
  double of_point = 0;        // length of what it was before it kept a disc's radius
  std::vector<Point> points;  // the polyline; none where a disc's was not wanted
  std::vector<Cell> raster;   // the cells under it
  bool made = false;          // ahead of the others

  std::int64_t bytes() const noexcept { return held_bytes(points, raster); }
};

/// Polishes the tours of one iteration, over threads.
class Polisher {
 public:
  /// Gets ready for a run. All but the number of threads must outlive it. `disc`: whose paths, null
  /// for a point's; as run_colony().
  void reset(const Grid& grid, const Request& request, const kernels::Moves& moves,
             const Params& params, int threads, const disc::DiscSpace* disc,
             const TourMeasure& measure);

  /// Of a disc's paths, those are wanted from now on whose `of_point` is less than this; over a
  /// terrain those are made cheaper that cost no more.
  void want_below(double limit) noexcept { limit_ = limit; }

  /// Makes the path of every ant that arrived, unless tours are not to be polished. When stopped by
  /// `stop`, those whose loops are cut get rougher but valid paths, the others none. One of the
  /// threads does what is to be done `meanwhile`, if anything.
  void polish(std::span<const Ant> ants, const StopCondition& stop,
              const std::function<void()>& meanwhile);

  /// Makes the path of one ant ahead of the call that makes the others, on thread `thread`, unless
  /// the run is stopped; one that is made stays as it is.
  void polish_ahead(std::span<const Ant> ants, int ant, int thread);

  /// By ant; perhaps of more than there are.
  std::span<const PolishedPath> paths() const noexcept { return paths_; }

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  struct alignas(64) Scratch {  // of one thread
    GrowingArray<Cell> cells;   // of a tour
    PathMaker maker;

    std::int64_t bytes() const noexcept { return cells.bytes() + maker.bytes(); }
  };
  std::span<const Cell> swept_cells(std::span<const std::uint8_t> tour, const StopCondition& stop,
                                    GrowingArray<Cell>& cells) const;
  void cheapen(const Ant& ant, std::span<const Cell> way, const StopCondition& stop,
               PolishedPath& path) const;
  static void end_cheapened(PolishedPath& path);
  void make(const Ant& ant, const StopCondition& stop, Scratch& scratch, PolishedPath& path) const;

  const Grid* grid_ = nullptr;
  const kernels::Moves* moves_ = nullptr;
  const StopCondition* stop_ = nullptr;
  Cell start_;
  const Params* params_ = nullptr;
  const disc::DiscSpace* disc_ = nullptr;
  TourMeasure measure_;
  double limit_ = kInfinity;
  int threads_ = 1;
  std::vector<Scratch> scratch_;
  std::vector<PolishedPath> paths_;
};

}  // namespace lasius
