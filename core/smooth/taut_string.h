// Pulling a polyline taut, without allocation: the workspace behind pull_taut().
#pragma once

#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "kernels/sight/sight.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/moves.h"
#include "lasius/stop.h"

namespace lasius {

/// Finds the shortest path of a polyline's homotopy class, as `pull_taut()` states, with buffers
/// that are reused from call to call. One per thread. The spans it returns hold until the next
/// call.
class TautString {
 public:
  /// Pulls a valid polyline taut; vertices in half cells, at least one.
  void run(const Grid& grid, std::span<const kernels::HalfPoint> path,
           Corners corners = Corners::forbid, const StopCondition& stop = {});
  /// The same for a polyline through cell centres.
  void run(const Grid& grid, std::span<const Cell> cells, Corners corners = Corners::forbid,
           const StopCondition& stop = {});

  std::span<const Point> path() const noexcept { return points_; }

  std::int64_t bytes() const noexcept {  ///< memory held
    return held_bytes(input_, done_, todo_, chain_, corners_, points_);
  }

 private:
  /// A vertex; fixed where the path squeezes between diagonal blocks, as Corners::allow lets it.
  struct Vertex {
    kernels::HalfPoint at;
    bool fixed;
  };

  void add(kernels::HalfPoint p);
  void pull(const Grid& grid, Corners corners, const StopCondition& stop);
  void fix_squeezes(const Grid& grid);

  std::vector<Vertex> input_;
  std::vector<Vertex> done_;               // taut up to its last vertex but one
  std::vector<Vertex> todo_;               // the rest, last vertex first
  std::vector<kernels::HalfPoint> chain_;  // what takes the place of a vertex
  std::vector<kernels::HalfPoint> corners_;
  std::vector<Point> points_;
};

}  // namespace lasius
