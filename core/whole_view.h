// All corners that are seen from a place, however far: what a graph stores, and both ends of a
// query need.
#pragma once

#include <vector>

#include "kernels/scan_cone.h"
#include "kernels/scan_line.h"

namespace lasius::exact {

/// A scan without limits or rivals. A Sink has
///   void corner(int x, int y)  for each corner at which a taut path from the root may turn
///   bool go_on(std::int64_t words)  told of the work done, false to stop.
template <int S, class Sink>
struct WholeView {
  const kernels::ConeFrame& frame;
  Sink& sink;

  double corner(int u, int line, kernels::Turn) {
    sink.corner(S * u, frame.line0 + frame.down * line);
    return -1;
  }
  bool beaten(const kernels::Rival&, kernels::Fixed, int) const noexcept { return false; }
  kernels::ConeLimits limits() const noexcept {
    return kernels::whole_map<S>(frame.map, frame.lines());
  }
  bool go_on(std::int64_t words) { return sink.go_on(words); }
};

/// From the centre of a free cell, all round; centre (x, y) in half cells.
template <class Sink>
void view_from_centre(const kernels::BitmapView& map, int x, int y,
                      std::vector<kernels::Interval>& stack, Sink& sink) {
  const auto half_plane = [&]<int S>(int down) {
    const kernels::ConeFrame frame = kernels::frame_at<S>(map, x, y, down);
    WholeView<S, Sink> view{frame, sink};
    kernels::ConeScan<S, WholeView<S, Sink>>(frame, stack, view).from_centre(S > 0 ? map.width : 0);
  };
  for (const int down : {1, -1}) {
    half_plane.template operator()<1>(down);
    half_plane.template operator()<-1>(down);
  }
}

/// From lattice point (x, y) into the quadrant towards larger u = S * x and `down`. `along_line`
/// adds what is seen on the quadrant's horizontal side, which a cone leaves out.
template <int S, class Sink>
void view_quadrant(const kernels::BitmapView& map, int x, int y, int down, bool along_line,
                   std::vector<kernels::Interval>& stack, Sink& sink) {
  const kernels::ConeFrame frame = kernels::frame_at<S>(map, 2 * x, 2 * y, down);
  WholeView<S, Sink> view{frame, sink};
  if (along_line) {
    const auto report = [&](int column, bool) { sink.corner(S * column, y); };
    kernels::scan_line<S>(
        map, y, S * x, [&] { return view.limits().last_column; }, report);
  }
  kernels::ConeScan<S, WholeView<S, Sink>>(frame, stack, view).from_corner(0, kernels::kLevelSlope);
}

}  // namespace lasius::exact
