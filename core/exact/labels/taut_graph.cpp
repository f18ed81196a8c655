#include "core/exact/labels/taut_graph.h"

#include <algorithm>

namespace lasius::exact {

TautGraph::TautGraph(const CornerGraph& graph) {
  const std::uint32_t n = graph.size();
  corners_.reserve(n);
  first_.reserve(2 * std::size_t{n} + 1);
  edges_.reserve(static_cast<std::size_t>(graph.edge_count()));
  for (std::uint32_t v = 0; v < n; ++v) {
    const GraphCorner& corner = graph.corner(v);
    corners_.push_back(corner);
    for (const Side side : {kColumn, kLine}) {
      first_.push_back(static_cast<std::uint32_t>(edges_.size()));
      const auto here = graph.edges(v, side);
      edges_.insert(edges_.end(), here.begin(), here.end());
      graph.for_each_one_way(v, [&](std::uint32_t from) {
        const GraphCorner& other = graph.corner(from);
        if (corner.side_from(2 * other.x(), 2 * other.y()) == side) return;
        edges_.emplace_back(corner, other, from);
      });
      const auto begin = edges_.begin() + first_.back();
      if (edges_.end() - begin == static_cast<std::ptrdiff_t>(here.size())) continue;
      // By the turn away from the block's edge, of two in one direction the nearer first.
      const Quadrant quadrant = corner.quadrant(side);
      std::sort(begin, edges_.end(), [&](const GraphEdge& a, const GraphEdge& b) {
        const std::int64_t ax = quadrant.along(a.x), ay = quadrant.away(a.y);
        const std::int64_t bx = quadrant.along(b.x), by = quadrant.away(b.y);
        const std::int64_t turn = side == kLine ? ay * bx - by * ax : ax * by - bx * ay;
        return turn != 0 ? turn < 0 : ax + ay < bx + by;
      });
    }
  }
  first_.push_back(static_cast<std::uint32_t>(edges_.size()));
}

}  // namespace lasius::exact
