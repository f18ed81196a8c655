// The corners that are seen from a place: what a graph stores, and both ends of a query need.
#pragma once

#include <vector>

#include "core/base/special_values.h"
#include "core/exact/ellipse_limits.h"
#include "core/exact/quadrant.h"
#include "kernels/sight/scan_cone.h"
#include "kernels/sight/scan_line.h"

namespace lasius::exact {

/// A scan without rivals, of all that lies in an ellipse around its root. A Sink has
///   void corner(int x, int y)  for each corner at which a taut path from the root may turn
///   bool go_on(std::int64_t words)  told of the work done, false to stop.
template <int S, class Sink>
struct View {
  const kernels::ConeFrame& frame;
  const Ellipse& ellipse;
  Sink& sink;

  double corner(int u, int line, kernels::Turn) {
    sink.corner(S * u, frame.line0 + frame.down * line);
    return -1;
  }
  bool beaten(const kernels::Rival&, kernels::Fixed, int) const noexcept { return false; }
  kernels::ConeLimits limits() const noexcept {
    return limits_around<S>(frame.map, ellipse, frame.down, frame.line0);
  }
  bool go_on(std::int64_t words) { return sink.go_on(words); }
};

/// From the centre of a free cell, the ellipse's root, all round.
template <class Sink>
void view_from_centre(const kernels::BitmapView& map, const Ellipse& ellipse,
                      std::vector<kernels::Interval>& stack, Sink& sink) {
  const auto half_plane = [&]<int S>(int down) {
    const kernels::ConeFrame frame =
        kernels::frame_at<S>(map, ellipse.root.x, ellipse.root.y, down);
    View<S, Sink> view{frame, ellipse, sink};
    kernels::ConeScan<S, View<S, Sink>>(frame, stack, view).from_centre(S > 0 ? map.width : 0);
  };
  for (const int down : {1, -1}) {
    half_plane.template operator()<1>(down);
    half_plane.template operator()<-1>(down);
  }
}

/// All in a cone of a quadrant, from its root. S is the quadrant's `right`. `along_line` adds what
/// is seen on the quadrant's horizontal side, which a scan leaves out. A little beside the cone may
/// be told of as well.
template <int S, class Sink>
void view_quadrant(const kernels::BitmapView& map, const Quadrant& quadrant,
                   const QuadrantCone& cone, bool along_line, std::vector<kernels::Interval>& stack,
                   Sink& sink) {
  const int x = quadrant.x, y = quadrant.y;
  const kernels::ConeFrame frame = kernels::frame_at<S>(map, 2 * x, 2 * y, quadrant.down);
  const Ellipse everything{{2 * x, 2 * y}, {2 * x, 2 * y}, kInfinity};
  View<S, Sink> view{frame, everything, sink};
  if (along_line && cone.has_line()) {
    const auto report = [&](int column, bool) { sink.corner(S * column, y); };
    kernels::scan_line<S>(
        map, y, S * x, [&] { return view.limits().last_column; }, report);
  }
  kernels::ConeScan<S, View<S, Sink>>(frame, stack, view).from_corner(cone.left(), cone.right());
}

}  // namespace lasius::exact
