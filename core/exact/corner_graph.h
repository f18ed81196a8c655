// The corners of a map, and which of them see each other along edges of taut paths.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/large_array.h"
#include "core/base/special_values.h"
#include "core/exact/corner_landmarks.h"
#include "core/exact/quadrant.h"
#include "kernels/sight/sight.h"
#include "lasius/grid/grid.h"
#include "lasius/plan/preparation.h"

namespace lasius {
class ArrayReader;
class ArrayWriter;
}  // namespace lasius

namespace lasius::exact {

/// A lattice point where exactly one of the four cells is blocked, and where its edges are in its
/// chunk. Corners lie inside the map, so that their coordinates take 15 bits.
class GraphCorner {
 public:
  GraphCorner() = default;
  /// Signs of the direction from the corner to its blocked cell.
  GraphCorner(int x, int y, int block_x, int block_y) noexcept
      : x_(static_cast<std::uint16_t>(x | (block_x > 0 ? kBlock : 0))),
        y_(static_cast<std::uint16_t>(y | (block_y > 0 ? kBlock : 0))) {}

  int x() const noexcept { return x_ & (kBlock - 1); }
  int y() const noexcept { return y_ & (kBlock - 1); }
  int block_x() const noexcept { return (x_ & kBlock) != 0 ? 1 : -1; }
  int block_y() const noexcept { return (y_ & kBlock) != 0 ? 1 : -1; }

  Quadrant quadrant(Side side) const noexcept {
    const int towards = side == kColumn ? 1 : -1;
    return {x(), y(), -towards * block_x(), towards * block_y()};
  }
  /// The side on which a taut path leaves that came straight from (x, y), in half cells, through
  /// the opposite one.
  Side side_from(int x, int y) const noexcept {
    return block_y() * (y - 2 * this->y()) > block_x() * (x - 2 * this->x()) ? kLine : kColumn;
  }
  /// The same of any point.
  Side side_from(kernels::FinePoint p) const noexcept {
    const kernels::FinePoint at = kernels::fine({2 * x(), 2 * y()});
    return block_y() * (p.y - at.y) > block_x() * (p.x - at.x) ? kLine : kColumn;
  }
  /// The sign that the cross product of a path's directions before and behind the corner has when
  /// it bends around the block into that side.
  int bend(Side side) const noexcept { return side == kLine ? handed() : -handed(); }

  std::uint32_t first = 0;   ///< edges of the column side
  std::uint32_t middle = 0;  ///< edges of the line side
  std::uint32_t last = 0;    ///< past the end

 private:
  static constexpr int kBlock = 1 << 15;
  int handed() const noexcept { return block_x() * block_y(); }

  std::uint16_t x_ = 0, y_ = 0;
};
static_assert(sizeof(GraphCorner) == 16);

/// A corner in sight: its number and coordinates, and the side on which a path that comes along
/// this edge leaves it.
struct GraphEdge {
  std::uint32_t to_and_side = 0;
  std::uint16_t x = 0, y = 0;

  GraphEdge() = default;
  GraphEdge(const GraphCorner& from, const GraphCorner& to, std::uint32_t number) noexcept
      : to_and_side(number | (to.side_from(2 * from.x(), 2 * from.y()) == kLine ? kSideBit : 0)),
        x(static_cast<std::uint16_t>(to.x())),
        y(static_cast<std::uint16_t>(to.y())) {}
  friend bool operator==(const GraphEdge&, const GraphEdge&) = default;

  std::uint32_t to() const noexcept { return to_and_side & ~kSideBit; }
  Side side() const noexcept { return (to_and_side & kSideBit) != 0 ? kLine : kColumn; }
  static constexpr std::uint32_t kSideBit = std::uint32_t{1} << 31;
};
static_assert(sizeof(GraphEdge) == 8);

/// The tangent visibility graph of a map: an edge joins two corners that see each other where a
/// taut path may come along at both ends. Corners are numbered tile by tile, 8 x 8 lattice points
/// each.
class CornerGraph {
 public:
  /// Scans from every corner, in parallel; the result does not depend on the threads. Null if it
  /// would take more than the bytes allowed, or was stopped: `report` tells.
  static std::shared_ptr<CornerGraph> make(const Grid& grid, const PrepareOptions& options,
                                           Preparation& report);
  /// About what it would hold, in bytes: told by an eighth of the corners
  /// at most, evenly spread. Where that is more than the bytes allowed it may be less than all.
  static std::int64_t expected_bytes(const Grid& grid, const PrepareOptions& options);

  /// How many corners there are.
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(corners_.size()); }
  const GraphCorner& corner(std::uint32_t i) const noexcept { return corners_[i]; }
  /// Is there one at a lattice point inside the map?
  bool has_corner(int x, int y) const noexcept {
    return (tiles_[static_cast<std::int64_t>(tile_of(x, y))] >> place_of(x, y) & 1) != 0;
  }
  /// The corner at a lattice point that is one.
  std::uint32_t index(int x, int y) const noexcept {
    const std::size_t tile = tile_of(x, y);
    const int place = place_of(x, y);
    const std::uint64_t before = (std::uint64_t{1} << place) - 1;
    const std::uint64_t here = tiles_[static_cast<std::int64_t>(tile)];
    return ranks_[tile] + static_cast<std::uint32_t>(std::popcount(here & before));
  }
  /// What a corner sees on one side, from the block's edge on.
  std::span<const GraphEdge> edges(std::uint32_t i, Side side) const noexcept {
    const GraphCorner& c = corners_[i];
    const GraphEdge* all = chunks_[i >> kChunkBits].edges.get();
    return side == kColumn ? std::span(all + c.first, all + c.middle)
                           : std::span(all + c.middle, all + c.last);
  }
  /// On both sides.
  std::span<const GraphEdge> edges(std::uint32_t i) const noexcept {
    const GraphCorner& c = corners_[i];
    const GraphEdge* all = chunks_[i >> kChunkBits].edges.get();
    return {all + c.first, all + c.last};
  }
  /// Calls f(from) for each corner from which an edge leads here that does not lead back: where a
  /// path can only go straight on, or sight has no width.
  template <class F>
  void for_each_one_way(std::uint32_t to, F&& f) const {
    for (std::uint32_t i = one_way_[to]; i != 0; i = one_ways_[i].next) f(one_ways_[i].from);
  }
  const Landmarks& landmarks() const noexcept { return landmarks_; }

  /// How many times its straight distance the way from a landmark to a corner is at most, for nine
  /// corners in ten; infinite without landmarks.
  double detour() const noexcept { return detour_; }

  std::int64_t edge_count() const noexcept { return edge_count_; }
  std::int64_t bytes() const noexcept;

  /// To a file and back. What is read is checked to be a graph, not
  /// to be that of the map. @throws Error(file_broken)
  void save(ArrayWriter& to) const;
  static std::shared_ptr<CornerGraph> load(const Grid& grid, ArrayReader& from);

 private:
  static constexpr int kChunkBits = 6;
  static constexpr std::uint32_t kChunk = std::uint32_t{1} << kChunkBits;  // corners
  class Builder;

  // Edges of kChunk corners.
  struct Chunk {
    std::unique_ptr<GraphEdge[]> edges;
    std::uint32_t used = 0;
  };

  // Edges by where they lead: all that do not lead back.
  struct OneWay {
    std::uint32_t from, next;
  };

  bool leads_back(std::uint32_t from, const GraphEdge& edge) const noexcept {
    for (const GraphEdge& back : edges(edge.to(), edge.side() == kLine ? kColumn : kLine))
      if (back.to() == from) return true;
    return false;
  }
  void add_one_way(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t i = one_way_[to]; i != 0; i = one_ways_[i].next)
      if (one_ways_[i].from == from) return;
    one_ways_.push_back({from, one_way_[to]});
    one_way_[to] = static_cast<std::uint32_t>(one_ways_.size() - 1);
  }
  std::size_t tile_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y >> 3) * tiles_across_ + static_cast<std::size_t>(x >> 3);
  }
  static int place_of(int x, int y) noexcept { return (y & 7) << 3 | (x & 7); }
  void load_corners(const Grid& grid, ArrayReader& from);
  void load_edges(ArrayReader& from);

  std::size_t tiles_across_ = 0;
  ZeroArray<std::uint64_t> tiles_;    // a bit for each corner
  std::vector<std::uint32_t> ranks_;  // corners before a tile
  std::vector<GraphCorner> corners_;
  std::vector<Chunk> chunks_;
  std::vector<std::uint32_t> one_way_;  // by corner, the first that leads here; 0: none
  std::vector<OneWay> one_ways_;
  std::int64_t edge_count_ = 0;
  Landmarks landmarks_;
  double detour_ = kInfinity;
};

}  // namespace lasius::exact
