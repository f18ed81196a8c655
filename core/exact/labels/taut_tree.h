// Taut paths from one corner to others: Dijkstra's algorithm over stored edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/exact/labels/taut_graph.h"

namespace lasius::exact {

/// Keeps its memory, 24 bytes a corner, from tree to tree. One thread at a time.
class alignas(64) TautTree {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Node {
    double length = kInfinity;
    std::uint32_t parent = kNone;  ///< the corner before, on the way back to the root
    std::uint32_t stamp = 0;
    Side side = kColumn;  ///< on which to go on
    bool settled = false;
  };

  explicit TautTree(const TautGraph& graph) : graph_(&graph), nodes_(graph.size()) {}

  /// Leaves `root` by all edges, goes on where the path bends around the corner's block, keeps one
  /// shortest way to each corner. Calls settle(v, node) for each corner but the root, in
  /// the order of length. False: nothing is looked for behind v. Of equal lengths the smaller
  /// number comes first. Ends early when stopped.
  template <class Settle>
  void grow(std::uint32_t root, Poller& poller, const Settle& settle) {
    if (++stamp_ == 0) {
      nodes_.assign(nodes_.size(), {});
      stamp_ = 1;
    }
    nodes_[root] = {0, kNone, stamp_, kColumn, true};
    for (const Side side : {kColumn, kLine})
      for (const GraphEdge& edge : graph_->edges(root, side)) reach(root, 0, edge);
    while (!queue_.empty()) {
      std::ranges::pop_heap(queue_, std::greater<>());
      const Waiting waiting = queue_.back();
      queue_.pop_back();
      Node& node = nodes_[waiting.second];
      if (node.settled) continue;
      node.settled = true;
      if (!settle(waiting.second, std::as_const(node))) continue;
      if (poller.stop_after(expand(waiting.second))) break;
    }
    queue_.clear();
  }

 private:
  using Waiting = std::pair<double, std::uint32_t>;

  // Returns the work done.
  std::int64_t expand(std::uint32_t v) {
    const GraphCorner& corner = graph_->corner(v);
    const Node node = nodes_[v];
    const GraphCorner& parent = graph_->corner(node.parent);
    const std::int64_t x = corner.x() - parent.x(), y = corner.y() - parent.y();
    const int bend = corner.bend(node.side);
    std::int64_t work = 4;
    for (const GraphEdge& edge : graph_->edges(v, node.side)) {
      if ((x * (edge.y - corner.y()) - y * (edge.x - corner.x())) * bend < 0) break;
      reach(v, node.length, edge);
      ++work;
    }
    return work;
  }

  void reach(std::uint32_t from, double before, const GraphEdge& edge) {
    const GraphCorner& corner = graph_->corner(from);
    const double x = edge.x - corner.x(), y = edge.y - corner.y();
    const double length = before + std::sqrt(x * x + y * y);
    Node& node = nodes_[edge.to()];
    if (node.stamp == stamp_ && (node.settled || length >= node.length)) return;
    node = {length, from, stamp_, edge.side(), false};
    queue_.emplace_back(length, edge.to());
    std::ranges::push_heap(queue_, std::greater<>());
  }

  const TautGraph* graph_;
  std::vector<Node> nodes_;
  std::uint32_t stamp_ = 0;
  std::vector<Waiting> queue_;  // a heap
};

}  // namespace lasius::exact
