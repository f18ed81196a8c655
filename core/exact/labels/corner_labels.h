// Hub labels of a map's corners, and for each tile of cells which corners they see.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/exact/corner_graph.h"
#include "core/exact/labels/label_builder.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/plan/preparation.h"

namespace lasius::exact {

/// Where a corner's label is: groups of entries that begin with the same edge, by side, in the
/// order of the turn, the block's edge first.
struct LabelCorner {
  std::uint32_t first = 0;   ///< group of the column side
  std::uint32_t middle = 0;  ///< of the line side
  std::uint32_t last = 0;    ///< past the end
  std::uint32_t rank = 0;
};

/// The corner at the far end of an edge, and the first of the entries that lie behind it.
struct LabelGroup {
  std::uint16_t x = 0, y = 0;
  std::uint32_t first = 0;
};

/// How the way of an entry goes on.
struct LabelStep {
  std::uint32_t corner = 0;  ///< the next one
  std::uint32_t entry = 0;   ///< the next corner's for the same hub; kArrived: it is the hub
};

/// A corner that a tile's cells see.
struct TileCorner {
  std::uint32_t number = 0;
  std::uint16_t x = 0, y = 0;  ///< the highest bits: the block lies towards larger x, y

  GraphCorner corner() const noexcept {
    return {x & 0x7fff, y & 0x7fff, (x & 0x8000) != 0 ? 1 : -1, (y & 0x8000) != 0 ? 1 : -1};
  }
};

/// What cells of a tile see, as where it begins; the next tile's says where it ends. *Live*: a way
/// over the corner can go on from some cell of the tile to another corner. *Full*: every free cell
/// of the tile sees it; else a mask has a bit for each one that does.
struct Tile {
  std::uint32_t live_full = 0, live_partial = 0;
  std::uint32_t dead_full = 0, dead_partial = 0;
  std::uint32_t masks = 0;  ///< of the live ones, then of the dead ones
};

/// The arrays of labels, as they are kept in files.
struct LabelArrays {
  std::vector<LabelCorner> corners;
  std::vector<LabelGroup> groups;   ///< and one past the end
  std::vector<std::uint32_t> hubs;  ///< by entry, ranks
  std::vector<double> lengths;      ///< by entry
  std::vector<LabelStep> steps;     ///< by entry
  std::vector<Tile> tiles;          ///< 8 x 8 cells each, row by row, and one past the end
  std::vector<TileCorner> live;
  std::vector<std::uint32_t> dead;   ///< numbers of corners
  std::vector<std::uint64_t> masks;  ///< bit 8 y + x for the tile's cell (x, y)
};

class CornerLabels {
 public:
  static constexpr std::uint32_t kArrived = ~std::uint32_t{0};
  static constexpr int kTileBits = 3;

  /// Makes labels of a graph. Null if they would take more than the options allow, too long, or
  /// were stopped: `report` tells. The same for any number of threads.
  /// @param order  corners of the graph by rank; empty: found
  static std::shared_ptr<const CornerLabels> make(const Grid& grid, const CornerGraph& graph,
                                                  const PrepareOptions& options,
                                                  Preparation::Labels& report,
                                                  std::vector<std::uint32_t> order = {});
  /// The order that these labels, of another graph, give the corners of a graph by where they are,
  /// new ones last; empty where more than a few are new.
  std::vector<std::uint32_t> order_of(const CornerGraph& own, const CornerGraph& graph) const;

  const LabelArrays& arrays() const noexcept { return arrays_; }
  std::size_t tile_of(Cell c) const noexcept {
    return static_cast<std::size_t>(c.y >> kTileBits) * tiles_across_ +
           static_cast<std::size_t>(c.x >> kTileBits);
  }
  static int place_of(Cell c) noexcept { return (c.y & 7) << kTileBits | (c.x & 7); }
  std::int64_t entry_count() const noexcept {
    return static_cast<std::int64_t>(arrays_.hubs.size());
  }
  std::int64_t bytes() const noexcept;

  /// As CornerGraph's, beside that of the graph that they are of.
  void save(ArrayWriter& to) const;
  static std::shared_ptr<const CornerLabels> load(const Grid& grid, const CornerGraph& graph,
                                                  ArrayReader& from);

 private:
  LabelArrays arrays_;
  std::size_t tiles_across_ = 0;
};

}  // namespace lasius::exact
