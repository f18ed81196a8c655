// Landmarks after an edit of the map: what they know bounds again.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/exact/corner_graph.h"

namespace lasius::exact {

/// Restores what Landmarks promise along new edges. A corner that was not there before takes the
/// largest number that its neighbours allow. Where a new edge is shorter than what the numbers of
/// its ends differ by, the larger one is lowered, and so on behind it, which keeps distances what
/// they are. If those are more than a few corners, the smaller one is raised, and so on towards the
/// landmark: the corners near its shortest way to here, which are fewer, mostly. If both are too
/// many, the landmark is dropped.
class LandmarkMender {
 public:
  LandmarkMender(const CornerGraph& graph, Landmarks& landmarks)
      : graph_(graph), landmarks_(landmarks) {}

  void mend(std::span<const DirectedEdge> edges);

  /// Restores all landmarks along all edges of these corners, whatever work it takes, by raising
  /// alone. Precondition: the promise holds along edges between other corners.
  void raise_all(std::span<const std::uint32_t> corners);

 private:
  // Corners that may be looked at for a landmark, at the first try and at the others.
  static constexpr std::size_t kFewCorners = 256, kMostCorners = 8192;

  float& known(std::uint32_t corner) { return landmarks_.at(corner, landmark_); }
  float way(std::uint32_t from, std::uint32_t to) const noexcept {
    const GraphCorner &a = graph_.corner(from), &b = graph_.corner(to);
    return landmarks_.way(a.x() - b.x(), a.y() - b.y());
  }
  // f(other, way) for each corner that an edge joins with this one.
  template <class F>
  void for_each_neighbour(std::uint32_t corner, F&& f) const {
    const int x = graph_.corner(corner).x(), y = graph_.corner(corner).y();
    for (const GraphEdge& edge : graph_.edges(corner)) {
      f(edge.to(), landmarks_.way(x - edge.x, y - edge.y));
    }
    graph_.for_each_one_way(corner, [&](std::uint32_t from) { f(from, way(from, corner)); });
  }
  void set(std::uint32_t corner, float value);
  bool reach_unknown(std::span<const DirectedEdge> edges);
  template <bool kRaise>
  void offer(std::uint32_t from, std::uint32_t to, float way);
  template <bool kRaise>
  bool spread(std::size_t most);
  template <bool kRaise>
  bool restore(std::span<const DirectedEdge> edges, std::size_t most);
  void undo(std::size_t kept);

  const CornerGraph& graph_;
  Landmarks& landmarks_;
  std::size_t landmark_ = 0;  // in hand
  std::vector<std::uint32_t> queue_;
  std::vector<std::uint32_t> reached_;                        // that were not known
  std::vector<std::pair<std::uint32_t, float>> overwritten_;  // in that order
};

}  // namespace lasius::exact
