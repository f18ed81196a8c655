// Straightening without allocation: the workspace behind greedy_straighten() and straighten().
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/disc/disc_space.h"
#include "core/smooth/taut_string.h"
#include "kernels/sight/sight.h"
#include "kernels/sight/sight_cone.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Which centres of free cells can be gone to straight: by a point, or by a disc's centre.
struct CellSight {
  kernels::BitmapView map;
  const disc::DiscSpace* disc = nullptr;  ///< null for a point

  bool operator()(Cell a, Cell b) const noexcept {
    return disc != nullptr ? disc->sees(centre(a), centre(b))
                           : kernels::sees_cell(map, a.x, a.y, b.x, b.y);
  }
};

/// The cells under a polyline, one a neighbour of the next by moves that the sight allows.
void rasterise(const CellSight& sight, std::span<const Cell> polyline, std::vector<Cell>& cells);

/// Straightens walks as `greedy_straighten()` states, with buffers that are reused from call to
/// call. One per thread. The spans it returns hold until the next call.
class Straightener {
 public:
  /// Straightens a walk of at least one cell; see `greedy_straighten()` for what a walk is. Each
  /// pass replaces only stretches, of what the pass before left, that keep within `window` cells of
  /// the segment's line and go no farther than that beyond its end; so many passes may together go
  /// farther from the walk.
  void run(const Grid& grid, std::span<const Cell> walk, const StopCondition& stop = {},
           double window = kInfinity);

  /// Goes on from the polyline of `run`, as `straighten()` states.
  void straighten(const Grid& grid, const StopCondition& stop = {});

  /// A taut string between the same ends in place of the polyline, put on cells and straightened,
  /// if it is shorter there.
  void take(const Grid& grid, std::span<const Point> string, const StopCondition& stop = {});

  /// Makes the polyline one of a disc: straightens the walk over cells() anew, by the disc's sight.
  /// `grid` has the cells whose centres are clear, and the walk's moves keep the radius
  /// (core/disc/disc_cells.h). Where sight ends is sought by steps of doubled length.
  ///   settled  vertices are left out or moved by a cell, too, as straighten() does
  void keep_radius(const Grid& grid, const disc::DiscSpace& disc, bool settled,
                   const StopCondition& stop = {});

  /// Cells at the vertices of the polyline, first and last cell included (one cell if equal).
  std::span<const Cell> vertices() const noexcept { return best_; }

  /// Cells the polyline crosses, in order, each once for every visit. All free; consecutive ones
  /// are 4-neighbours, except across a kept squeeze between two diagonal blocks. keep_radius()
  /// leaves them as they were.
  std::span<const Cell> cells() const noexcept { return raster_; }

  /// The taut string of its class, once `straighten` was through with three vertices or more.
  std::span<const Point> string() const noexcept { return taut_string_.path(); }

  std::int64_t bytes() const noexcept {  ///< memory held
    return taut_string_.bytes() + held_bytes(layers_, best_, pulled_, raster_, point_raster_) +
           cone_.bytes();
  }

 private:
  /// Cells on every side of a corner of the taut string. With 2 a whole plan takes a third longer
  /// and its path is 0.04% shorter (fan2004 on maps/fan400x200.map).
  static constexpr int kReach = 1;
  static constexpr int kCells = 4 * kReach * kReach;

  /// Cells around a corner, and the shortest polyline to each.
  struct Layer {
    std::array<Cell, kCells> cell{};
    std::array<double, kCells> length{};
    std::array<int, kCells> from{};  ///< in the layer before
    int count = 0;
  };

  void pull_all(const CellSight& sight, Poller& poller);
  bool pull_from_both_ends(const CellSight& sight, Poller& poller);
  bool keep_if_shorter();
  bool string_on_cells(const Grid& grid, std::span<const Point> string, Poller& poller);
  static bool connect(const kernels::BitmapView& map, Poller& poller, const Layer& before,
                      Layer& layer);

  TautString taut_string_;
  std::vector<Layer> layers_;
  std::vector<Cell> best_;          // shortest polyline so far, from the walk's first cell
  std::vector<Cell> pulled_;        // the polyline of one pass, in the pass's direction
  std::vector<Cell> raster_;        // the walk that a pass pulls, at the end the result's cells
  std::vector<Cell> point_raster_;  // what it was before keep_radius
  double length_ = 0;
  double window_ = 0;
  kernels::SightCone cone_;
};

}  // namespace lasius
