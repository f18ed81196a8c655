#include <algorithm>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/exact/box_view.h"
#include "core/exact/corner_graph.h"
#include "core/exact/corner_sight.h"
#include "core/exact/mend_landmarks.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {

// An edge is between two corners and the cells that touch its segment. So one that comes, goes or
// leads to another side touches the closed rectangle that changed, and outside of it is in sight
// from both ends, before and after. All corners with such edges are found by a look around from the
// rectangle; each looks again at the cone that the rectangle takes up.
class CornerGraph::Updater {
 public:
  Updater(CornerGraph& graph, const Grid& grid, const Rectangle& changed, const StopCondition& stop)
      : graph_(graph),
        map_(view_of(grid)),
        box_(lattice_box(changed, 0)),
        around_(lattice_box(changed, 1)),
        poller_(stop),
        sight_(stop) {}

  bool run() {
    find_corners_in_sight();
    if (poller_.stopped()) return false;
    renumber();
    for (const std::uint32_t corner : in_sight_) {
      rescan(corner);
      if (poller_.stop_after(kWordsPerCorner)) return false;
    }
    list_one_ways();
    LandmarkMender(graph_, graph_.landmarks_).mend(new_edges_);
    return !poller_.stopped();
  }

  // What view_from_box calls.
  void corner(int x, int y) {
    if (!around_.holds(x, y)) in_sight_.push_back(graph_.index(x, y));
  }
  bool go_on(std::int64_t words) { return !poller_.stop_after(words); }

 private:
  static constexpr std::int64_t kWordsPerCorner = 256;  // of work, mostly waiting for memory

  LatticeBox lattice_box(const Rectangle& r, int around) const noexcept {
    return {std::max(r.x - around, 0), std::max(r.y - around, 0),
            std::min(r.x + r.width + around, map_.width),
            std::min(r.y + r.height + around, map_.height)};
  }

  void find_corners_in_sight();
  void renumber();
  void renumber(int x, int y);
  std::uint64_t& renumbered_tile(int x, int y);
  void add_corner(const GraphCorner& corner);
  void drop_corner(std::uint32_t index);
  void rescan(std::uint32_t index);
  bool rescan(std::uint32_t index, Side side);
  void compare(std::uint32_t index, std::span<const GraphEdge> before,
               std::span<const GraphEdge> now);
  void list_one_ways();
  void store(std::uint32_t index, std::uint32_t middle);
  void repack(Chunk& chunk, std::uint32_t first_corner, std::uint32_t more);

  CornerGraph& graph_;
  const kernels::BitmapView map_;
  const LatticeBox box_;     // lattice points whose cells may have changed
  const LatticeBox around_;  // and those a cell around
  Poller poller_;
  CornerSight sight_;
  std::vector<std::uint32_t> in_sight_;
  std::vector<GraphEdge> edges_;  // of the corner in hand
  std::vector<DirectedEdge> new_edges_, lost_edges_;
};

// Corners outside the box that may see it. Their numbers are those from before.
void CornerGraph::Updater::find_corners_in_sight() {
  view_from_box(map_, around_, *this);
  for (int y = around_.y0; y <= around_.y1; ++y) {
    for (int x = around_.x0; x <= around_.x1; ++x) {
      if (!box_.holds(x, y) && graph_.has_corner(x, y)) in_sight_.push_back(graph_.index(x, y));
    }
  }
  std::sort(in_sight_.begin(), in_sight_.end());
  in_sight_.erase(std::unique(in_sight_.begin(), in_sight_.end()), in_sight_.end());
}

void CornerGraph::Updater::renumber() {
  for (int y = box_.y0; y <= box_.y1; ++y) {
    for (int x = box_.x0; x <= box_.x1; ++x) renumber(x, y);
  }
}

void CornerGraph::Updater::renumber(int x, int y) {
  const bool a = map_.blocked(x - 1, y - 1), b = map_.blocked(x, y - 1);
  const bool c = map_.blocked(x - 1, y), d = map_.blocked(x, y);
  const bool is_corner = a + b + c + d == 1;
  const GraphCorner now(x, y, b || d ? 1 : -1, c || d ? 1 : -1);
  if (graph_.has_corner(x, y)) {
    const std::uint32_t index = graph_.index(x, y);
    const GraphCorner& before = graph_.corner(index);
    if (is_corner && before.block_x() == now.block_x() && before.block_y() == now.block_y()) {
      in_sight_.push_back(index);
      return;
    }
    renumbered_tile(x, y) &= ~(std::uint64_t{1} << place_of(x, y));
    drop_corner(index);
  }
  if (is_corner) {
    renumbered_tile(x, y) |= std::uint64_t{1} << place_of(x, y);
    add_corner(now);
  }
}

// The bits of a tile whose corners are numbered one by one from now on.
std::uint64_t& CornerGraph::Updater::renumbered_tile(int x, int y) {
  CornerGraph& g = graph_;
  const std::size_t tile = g.tile_of(x, y);
  std::uint64_t& bits = g.tiles_[static_cast<std::int64_t>(tile)];
  if ((g.ranks_[tile] & kRenumbered) != 0) return bits;
  auto& numbers = g.renumbered_.emplace_back();
  std::uint32_t rank = g.ranks_[tile];
  for (std::uint64_t left = bits; left != 0; left &= left - 1) {
    numbers[static_cast<std::size_t>(std::countr_zero(left))] = rank++;
  }
  g.ranks_[tile] = kRenumbered | static_cast<std::uint32_t>(g.renumbered_.size() - 1);
  return bits;
}

void CornerGraph::Updater::add_corner(const GraphCorner& corner) {
  CornerGraph& g = graph_;
  if (g.spare_.empty()) {
    g.spare_.push_back(g.size());
    g.corners_.emplace_back();
    g.one_way_.emplace_back();
    if (g.chunks_.size() << kChunkBits < g.corners_.size()) g.chunks_.emplace_back();
  }
  const std::uint32_t index = g.spare_.back();
  g.spare_.pop_back();
  g.corners_[index] = corner;
  g.landmarks_.forget(index);
  const std::uint32_t place = g.ranks_[g.tile_of(corner.x(), corner.y())] & ~kRenumbered;
  g.renumbered_[place][static_cast<std::size_t>(place_of(corner.x(), corner.y()))] = index;
  in_sight_.push_back(index);
}

// The edges that lead here are dropped where they come from.
void CornerGraph::Updater::drop_corner(std::uint32_t index) {
  GraphCorner& corner = graph_.corners_[index];
  graph_.edge_count_ -= corner.last - corner.first;
  corner = GraphCorner(corner.x(), corner.y(), corner.block_x(), corner.block_y());
  graph_.spare_.push_back(index);
}

void CornerGraph::Updater::rescan(std::uint32_t index) {
  edges_.clear();
  bool changed = rescan(index, kColumn);
  const auto middle = static_cast<std::uint32_t>(edges_.size());
  changed |= rescan(index, kLine);
  if (changed) store(index, middle);
}

// Adds the edges of one side; true if they changed.
bool CornerGraph::Updater::rescan(std::uint32_t index, Side side) {
  const GraphCorner& corner = graph_.corner(index);
  const auto before = graph_.edges(index, side);
  const Quadrant quadrant = corner.quadrant(side);
  QuadrantCone cone;
  if (!quadrant.meets(box_, cone)) {
    edges_.insert(edges_.end(), before.begin(), before.end());
    return false;
  }
  const auto before_cone = [&](const GraphEdge& edge) {
    const std::int64_t along = quadrant.along(edge.x), away = quadrant.away(edge.y);
    return side == kColumn ? cone.is_steeper(along, away) : cone.is_flatter(along, away);
  };
  const auto in_cone = [&](const GraphEdge& edge) {
    return cone.holds(quadrant.along(edge.x), quadrant.away(edge.y));
  };
  const auto first = std::find_if_not(before.begin(), before.end(), before_cone);
  const auto last = std::find_if_not(first, before.end(), in_cone);
  edges_.insert(edges_.end(), before.begin(), first);
  const std::size_t kept = edges_.size();
  for (const auto [x, y] : sight_.from(map_, quadrant, side, cone)) {
    const std::uint32_t to = graph_.index(x, y);
    edges_.emplace_back(corner, graph_.corner(to), to);
  }
  const auto seen = std::span<const GraphEdge>(edges_).subspan(kept);
  const bool same = std::equal(first, last, seen.begin(), seen.end());
  if (!same) {
    const auto from = static_cast<std::size_t>(first - before.begin());
    compare(index, before.subspan(from, static_cast<std::size_t>(last - first)), seen);
  }
  edges_.insert(edges_.end(), last, before.end());
  return !same;
}

void CornerGraph::Updater::compare(std::uint32_t index, std::span<const GraphEdge> before,
                                   std::span<const GraphEdge> now) {
  const auto add_missing = [&](const auto& from, const auto& in, std::vector<DirectedEdge>& list) {
    for (const GraphEdge& edge : from) {
      if (std::find(in.begin(), in.end(), edge) == in.end()) list.push_back({index, edge});
    }
  };
  add_missing(now, before, new_edges_);
  add_missing(before, now, lost_edges_);
}

// Once all edges are what they are to be.
void CornerGraph::Updater::list_one_ways() {
  for (const DirectedEdge& e : new_edges_) {
    if (!graph_.leads(e.edge.to(), e.from)) graph_.add_one_way(e.from, e.edge.to());
  }
  for (const DirectedEdge& e : lost_edges_) {
    if (graph_.leads(e.edge.to(), e.from)) graph_.add_one_way(e.edge.to(), e.from);
  }
}

void CornerGraph::Updater::store(std::uint32_t index, std::uint32_t middle) {
  GraphCorner& corner = graph_.corners_[index];
  Chunk& chunk = graph_.chunks_[index >> kChunkBits];
  const auto count = static_cast<std::uint32_t>(edges_.size());
  const std::uint32_t before = corner.last - corner.first;
  graph_.edge_count_ += std::int64_t{count} - before;
  if (count > before) {
    corner.last = corner.first;
    if (chunk.used + count > chunk.capacity) repack(chunk, index & ~(kChunk - 1), count);
    corner.first = chunk.used;
    chunk.used += count;
  }
  std::copy(edges_.begin(), edges_.end(), chunk.edges.get() + corner.first);
  corner.middle = corner.first + middle;
  corner.last = corner.first + count;
}

// Closes the gaps, with room for more edges.
void CornerGraph::Updater::repack(Chunk& chunk, std::uint32_t first_corner, std::uint32_t more) {
  const std::uint32_t end = std::min(first_corner + kChunk, graph_.size());
  std::uint32_t held = 0;
  for (std::uint32_t i = first_corner; i < end; ++i) {
    held += graph_.corners_[i].last - graph_.corners_[i].first;
  }
  Chunk packed;
  packed.capacity = (held + more) + (held + more) / 4;
  packed.edges = std::make_unique_for_overwrite<GraphEdge[]>(packed.capacity);
  for (std::uint32_t i = first_corner; i < end; ++i) {
    GraphCorner& corner = graph_.corners_[i];
    const std::uint32_t moved = packed.used - corner.first;
    std::copy(chunk.edges.get() + corner.first, chunk.edges.get() + corner.last,
              packed.edges.get() + packed.used);
    packed.used += corner.last - corner.first;
    corner.first += moved;
    corner.middle += moved;
    corner.last += moved;
  }
  graph_.edge_room_ += std::int64_t{packed.capacity} - chunk.capacity;
  chunk = std::move(packed);
}

bool CornerGraph::update(const Grid& grid, const Rectangle& changed, const StopCondition& stop) {
  if (changed.width <= 0 || changed.height <= 0) return true;
  return Updater(*this, grid, changed, stop).run();
}

}  // namespace lasius::exact
