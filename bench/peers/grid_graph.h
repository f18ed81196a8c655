// A grid as a Boost.Graph: implicit, nothing stored but the moves of each cell.
#pragma once

#include <bit>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstdint>
#include <utility>

#include "bench/peers/move_grid.h"

namespace lasius::peers {

/// One move out of a cell.
struct GridEdge {
  std::uint32_t source, target;
  bool diagonal;
  friend bool operator==(const GridEdge&, const GridEdge&) = default;
};

struct GridGraph {
  const MoveGrid* moves;
};

/// Runs over the moves of one cell, a bit of its mask at a time.
class GridEdgeIterator : public boost::iterator_facade<GridEdgeIterator, GridEdge,
                                                       boost::forward_traversal_tag, GridEdge> {
 public:
  GridEdgeIterator() = default;
  GridEdgeIterator(const MoveGrid& moves, std::uint32_t source, unsigned mask)
      : moves_(&moves), source_(source), mask_(mask) {}

 private:
  friend class boost::iterator_core_access;
  GridEdge dereference() const {
    const auto k = static_cast<unsigned>(std::countr_zero(mask_));
    return {source_, source_ + static_cast<std::uint32_t>(moves_->offsets()[k]), k >= 4};
  }
  bool equal(const GridEdgeIterator& other) const { return mask_ == other.mask_; }
  void increment() { mask_ &= mask_ - 1; }

  const MoveGrid* moves_ = nullptr;
  std::uint32_t source_ = 0;
  unsigned mask_ = 0;
};

inline std::pair<GridEdgeIterator, GridEdgeIterator> out_edges(std::uint32_t v,
                                                               const GridGraph& graph) {
  return {{*graph.moves, v, graph.moves->moves(v)}, {*graph.moves, v, 0}};
}
inline std::size_t out_degree(std::uint32_t v, const GridGraph& graph) {
  return static_cast<std::size_t>(std::popcount(graph.moves->moves(v)));
}
inline std::uint32_t source(const GridEdge& edge, const GridGraph&) { return edge.source; }
inline std::uint32_t target(const GridEdge& edge, const GridGraph&) { return edge.target; }

}  // namespace lasius::peers

template <>
struct boost::graph_traits<lasius::peers::GridGraph> {
  using vertex_descriptor = std::uint32_t;
  using edge_descriptor = lasius::peers::GridEdge;
  using out_edge_iterator = lasius::peers::GridEdgeIterator;
  using degree_size_type = std::size_t;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = boost::incidence_graph_tag;
  static vertex_descriptor null_vertex() { return ~std::uint32_t{0}; }
};
