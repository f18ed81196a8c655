// A CornerGraph in a file.
#include <bit>
#include <cmath>

#include "core/base/stored_arrays.h"
#include "core/exact/corner_graph.h"

namespace lasius::exact {

void CornerGraph::save(ArrayWriter& to) const {
  to.array(std::span(tiles_.at(0), ranks_.size()));
  to.array(corners_);
  std::vector<GraphEdge> all;
  all.reserve(static_cast<std::size_t>(edge_count_));
  for (const Chunk& chunk : chunks_)
    all.insert(all.end(), chunk.edges.get(), chunk.edges.get() + chunk.used);
  to.array(all);
  to.array(one_way_);
  to.array(one_ways_);
  to.array(landmarks_.cells());
  std::vector<Landmarks::Distances> distances;
  if (!landmarks_.empty())
    for (std::uint32_t v = 0; v < size(); ++v) distances.push_back(landmarks_.distances(v));
  to.array(distances);
  to.value(landmarks_.grain());
  to.value(detour_);
}

void CornerGraph::load_corners(const Grid& grid, ArrayReader& from) {
  tiles_across_ = static_cast<std::size_t>(grid.width() >> 3) + 1;
  const std::size_t tile_count = tiles_across_ * (static_cast<std::size_t>(grid.height() >> 3) + 1);
  const auto tiles = from.array<std::uint64_t>();
  from.require(tiles.size() == tile_count);
  tiles_ = ZeroArray<std::uint64_t>(static_cast<std::int64_t>(tile_count));
  std::uint32_t count = 0;
  for (std::size_t t = 0; t < tile_count; ++t) {
    tiles_[static_cast<std::int64_t>(t)] = tiles[t];
    ranks_.push_back(count);
    count += static_cast<std::uint32_t>(std::popcount(tiles[t]));
  }
  corners_ = from.array<GraphCorner>();
  from.require(size() == count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const GraphCorner& c = corners_[i];
    from.require(c.x() > 0 && c.y() > 0 && c.x() < grid.width() && c.y() < grid.height() &&
                 has_corner(c.x(), c.y()) && index(c.x(), c.y()) == i);
  }
}

void CornerGraph::load_edges(ArrayReader& from) {
  const auto edges = from.array<GraphEdge>();
  std::size_t before = 0;
  for (std::uint32_t begin = 0; begin < size(); begin += kChunk) {
    const std::uint32_t end = std::min(begin + kChunk, size());
    std::uint32_t used = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      const GraphCorner& c = corners_[i];
      from.require(c.first == used && c.first <= c.middle && c.middle <= c.last);
      used = c.last;
    }
    from.require(used <= edges.size() - before);
    Chunk chunk{std::make_unique_for_overwrite<GraphEdge[]>(used), used};
    for (std::uint32_t i = 0; i < used; ++i) {
      const GraphEdge& edge = chunk.edges[i] = edges[before + i];
      from.require(edge.to() < size() && edge.x == corners_[edge.to()].x() &&
                   edge.y == corners_[edge.to()].y());
    }
    chunks_.push_back(std::move(chunk));
    before += used;
  }
  from.require(before == edges.size());
  edge_count_ = static_cast<std::int64_t>(edges.size());
  one_way_ = from.array<std::uint32_t>();
  one_ways_ = from.array<OneWay>();
  from.require(one_way_.size() == size() && !one_ways_.empty());
  for (const std::uint32_t first : one_way_) from.require(first < one_ways_.size());
  for (std::size_t i = 1; i < one_ways_.size(); ++i)
    from.require(one_ways_[i].from < size() && one_ways_[i].next < i);
}

std::shared_ptr<CornerGraph> CornerGraph::load(const Grid& grid, ArrayReader& from) {
  auto made = std::make_shared<CornerGraph>();
  made->load_corners(grid, from);
  made->load_edges(from);
  auto cells = from.array<Cell>();
  for (const Cell c : cells) from.require(grid.contains(c));
  auto distances = from.array<Landmarks::Distances>();
  from.require(cells.size() <= Landmarks::kCount &&
               distances.size() == (cells.empty() ? 0 : made->size()));
  const auto grain = from.value<double>();
  from.require(std::isfinite(grain) && grain > 0);
  if (!cells.empty()) made->landmarks_ = Landmarks(std::move(cells), std::move(distances), grain);
  made->detour_ = from.value<double>();
  from.require(made->detour_ > 0);
  return made;
}

}  // namespace lasius::exact
