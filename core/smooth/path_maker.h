// From the cells of a walk to a path: loops cut, pulled straight or taut, shortcuts taken.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/exact.h"
#include "core/smooth/loop_cutter.h"
#include "core/smooth/straighten.h"
#include "core/smooth/taut_string.h"
#include "kernels/base/packed_cell.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"

namespace lasius {

/// Buffers are reused from call to call; one object per thread.
class PathMaker {
 public:
  /// The shortest way from a walk's first cell to its last within its cells and `more`, as
  /// LoopCutter has it; empty when stopped. Holds until the next call.
  std::span<const Cell> cut(const Grid& grid, std::span<const Cell> walk, bool diagonal,
                            Corners corners, const StopCondition& stop,
                            std::span<const kernels::PackedCell> more = {});

  /// The path along `way`, which `cut` returned, as Polish states; rougher when stopped.
  /// Precondition: `polish` is not none. For Polish::local any walk will do.
  void polish(const Grid& grid, std::span<const Cell> way, const Params& params,
              const StopCondition& stop, std::vector<Point>& path);

  /// The same for a disc, see Straightener::keep_radius: first for a point, over centres of cells.
  /// Returns that path's length. Unless it is less than `limit`, `path` is empty then; else the
  /// path is made to keep the radius, and for Polish::taut tightened.
  double polish(const Grid& grid, const disc::DiscSpace& disc, double limit,
                std::span<const Cell> way, const Params& params, const StopCondition& stop,
                std::vector<Point>& path);
  /// To be called where the disc or the parameters may be others: forgets paths of discs.
  void forget() noexcept {
    for (Known& one : known_) one.vertices.clear();
  }

  /// Cells under the last path, or under one of its class.
  std::span<const Cell> raster() const noexcept { return straightener_.cells(); }

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  /// A point's path over cells, and what a disc's path became of it: ants often find the same.
  struct Known {
    std::vector<Cell> vertices;
    std::vector<Point> path;
  };

  void make(const Grid& grid, std::span<const Cell> way, const Params& params, bool on_cells,
            const StopCondition& stop, std::vector<Point>& path);
  bool find_shortcut(const Grid& grid, std::span<const Cell> way, double length,
                     const StopCondition& stop);

  LoopCutter cutter_;
  Straightener straightener_;
  TautString taut_string_;
  ExactSearch search_;
  std::vector<Point> shortcut_;
  std::array<Known, 16> known_;
  std::size_t oldest_ = 0;  // of them
};

}  // namespace lasius
