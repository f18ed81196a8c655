// Lengths from one place to many, by one search of a prepared map.
#include <algorithm>

#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/exact/prepared_search.h"
#include "kernels/sight/sight.h"

namespace lasius::exact {

bool PreparedSearch::flood(const Grid& grid, const CornerGraph& graph, Cell start, double grain,
                           const StopCondition& stop, std::vector<double>& lengths) {
  Poller poller(stop);
  grain_ = grain;
  begin(grid, graph, centre(start), centre(start), Mode::flood, poller);
  reach_all(kInfinity);
  lengths.clear();
  lengths.reserve(graph.size());
  for (std::uint32_t i = 0; i < graph.size() && !poller.stop_after(sizeof(Node) / 8); ++i)
    lengths.push_back(nodes_[i].stamp == stamp_ ? nodes_[i].length : kInfinity);
  poller_ = nullptr;
  return poller.stopped();
}

void PreparedSearch::reach_all(double limit) {
  scan_start_view();
  restart();
  upper_ = limit;
  reach_start_corners();
  run(0, kNoBudget);
}

bool PreparedSearch::row(const Grid& grid, const CornerGraph& graph, Point from, Point to,
                         double bound, const StopCondition& stop, TautRow& row) {
  Poller poller(stop);
  begin(grid, graph, from, to, Mode::row, poller);
  horizon_ = bound;
  reach_all(bound);
  row.corners.clear();
  std::vector<std::uint32_t> places(graph.size(), TautRow::kEnd);
  // By rounding a corner may seem farther than one behind it on the same way.
  const double most = bound * (1 + 1e-9);
  for (std::uint32_t i = 0; i < graph.size() && !poller.stop_after(sizeof(Node) / 8); ++i) {
    const Node& node = nodes_[i];
    if (node.stamp != stamp_ || node.length + node.to_goal >= most) continue;
    places[i] = static_cast<std::uint32_t>(row.corners.size());
    const GraphCorner& corner = graph.corner(i);
    row.corners.push_back({corner.x(), corner.y(), node.length, node.parent});
  }
  for (TautRow::Corner& corner : row.corners)
    if (corner.parent != kStart) corner.parent = places[corner.parent];
  poller_ = nullptr;
  return poller.stopped();
}

bool PreparedSearch::view(const Grid& grid, const CornerGraph& graph, Point point,
                          const StopCondition& stop, Target& target) {
  Poller poller(stop);
  begin(grid, graph, point, point, Mode::all, poller);
  scan_start_view();
  target = {start_, start_corners_};
  poller_ = nullptr;
  return poller.stopped();
}

bool PreparedSearch::lengths_to(const Grid& grid, const CornerGraph& graph, Point start,
                                std::span<const Target> targets, const StopCondition& stop,
                                std::span<double> lengths, double limit) {
  Poller poller(stop);
  begin(grid, graph, start, start, Mode::all, poller);
  reach_all(limit);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto& [at, corners] = targets[i];
    const double straight = exact::distance(start_.x, start_.y, at.x, at.y);
    lengths[i] = kInfinity;
    if (straight >= limit) continue;
    if (start_.sees(map_, at)) {
      lengths[i] = straight;
      continue;
    }
    for (const std::uint32_t index : corners) {
      const Node& node = nodes_[index];
      if (node.stamp != stamp_) continue;
      const GraphCorner& corner = graph_->corner(index);
      lengths[i] = std::min(
          lengths[i], node.length + exact::distance(2 * corner.x(), 2 * corner.y(), at.x, at.y));
    }
    if (lengths[i] >= limit) lengths[i] = kInfinity;
    if (poller.stop_after(kWordsPerNode + static_cast<std::int64_t>(corners.size()))) break;
  }
  poller_ = nullptr;
  return poller.stopped();
}

}  // namespace lasius::exact
