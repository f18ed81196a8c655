// Pulling a polyline taut, without allocation: the workspace behind pull_taut().
#pragma once

#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "kernels/sight/sight.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// Finds the shortest path of a polyline's homotopy class, as `pull_taut()` states, with buffers
/// that are reused. One per thread. The spans it returns hold until the next call.
class TautString {
 public:
  /// Pulls a valid polyline taut; vertices in half cells, at least one.
  void run(const Grid& grid, std::span<const kernels::HalfPoint> path,
           Corners corners = Corners::forbid, const StopCondition& stop = {});
  /// The same for a polyline through cell centres.
  void run(const Grid& grid, std::span<const Cell> cells, Corners corners = Corners::forbid,
           const StopCondition& stop = {});
  /// The same for a polyline with one more vertex before it and one behind, any points that its
  /// first and its last vertex see.
  void run(const Grid& grid, Point from, std::span<const kernels::HalfPoint> path, Point to,
           Corners corners, const StopCondition& stop);

  std::span<const Point> path() const noexcept { return points_; }

  std::int64_t bytes() const noexcept {  ///< memory held
    return held_bytes(input_, half_.done, half_.todo, half_.chain, half_.corners, fine_.done,
                      fine_.todo, fine_.chain, fine_.corners, points_);
  }

 private:
  /// A vertex; fixed where the path squeezes between diagonal blocks, as Corners::allow lets it.
  template <class P>
  struct VertexAt {
    P at;
    bool fixed;
  };
  using Vertex = VertexAt<kernels::HalfPoint>;
  template <class P>
  struct Work {
    std::vector<VertexAt<P>> done;  // taut up to its last vertex but one
    std::vector<VertexAt<P>> todo;  // the rest, last vertex first
    std::vector<P> chain;           // what takes the place of a vertex
    std::vector<P> corners;
  };

  void add(kernels::HalfPoint p);
  void pull(const Grid& grid, Corners corners, const StopCondition& stop);
  template <class P>
  static void pull(const Grid& grid, Work<P>& work, const StopCondition& stop);
  void fix_squeezes(const Grid& grid);

  std::vector<Vertex> input_;
  Work<kernels::HalfPoint> half_;
  Work<kernels::FinePoint> fine_;
  std::vector<Point> points_;
};

}  // namespace lasius
