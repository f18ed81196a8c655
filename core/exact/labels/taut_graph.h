// The edges of a visibility graph, each listed at both of its ends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/corner_graph.h"

namespace lasius::exact {

/// The edges of a CornerGraph side by side, and for each that leads one way only the way back: it
/// lies on the side on which a path that goes the other way leaves. So a taut path can be walked
/// from either end. 8 bytes an edge, 8 a corner.
class TautGraph {
 public:
  explicit TautGraph(const CornerGraph& graph);

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(corners_.size()); }
  const GraphCorner& corner(std::uint32_t v) const noexcept { return corners_[v]; }
  /// What a corner sees on one side, from the block's edge on.
  std::span<const GraphEdge> edges(std::uint32_t v, Side side) const noexcept {
    return {edges_.data() + first_[2 * v + side], edges_.data() + first_[2 * v + side + 1]};
  }
  std::size_t edge_count() const noexcept { return edges_.size(); }

 private:
  std::vector<GraphCorner> corners_;
  std::vector<std::uint32_t> first_;  // by corner and side; one past the end
  std::vector<GraphEdge> edges_;
};

}  // namespace lasius::exact
