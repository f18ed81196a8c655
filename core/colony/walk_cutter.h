// Cuts an ant's tour down to the shortest way within its own cells.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/large_array.h"
#include "core/grid/cell_set.h"
#include "kernels/base/moves.h"
#include "kernels/base/packed_cell.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// The shortest way from a tour's start to its end over the ant's own cells, by its own moves:
/// loops go, and detours past cells of its own. It knows nothing of other ants nor of the map
/// beside those cells; so it is part of a walk, not a polish.
///
/// Time and memory follow the tour, not the map. Buffers are reused; one object per thread.
class WalkCutter {
 public:
  /// Writes the moves of that way into `way` and returns their number; -1 when stopped. The tour
  /// begins at `start`, enters no cell twice and was made of `moves` under `corners`; `more` are
  /// further cells of the ant's. Of ways of equal length it takes one by a fixed order.
  std::int64_t cut(const Grid& grid, Corners corners, const kernels::Moves& moves, Cell start,
                   std::span<const std::uint8_t> tour, std::span<const kernels::PackedCell> more,
                   const StopCondition& stop, GrowingArray<std::uint8_t>& way);

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  using Around = std::array<std::int32_t, 9>;  // the tiles next to one and itself, row by row
  struct Node {
    double length;
    std::int32_t before;  // the node that it was reached from
    std::uint8_t move;    // by which
  };
  struct Entry {
    double length;
    std::int32_t tile;
    std::int32_t bit;
  };

  bool collect(const kernels::Moves& moves, Cell start, std::span<const std::uint8_t> tour,
               std::span<const kernels::PackedCell> more, const StopCondition& stop);
  static std::int32_t number(Entry e) noexcept { return e.tile * 64 + e.bit; }
  Entry entry(Cell c) const noexcept;
  void expand(const Grid& grid, Corners corners, const kernels::Moves& moves, Entry from);

  // A bucket is as wide as the shortest move is long: what waits in the first one has its length.
  static constexpr int kBuckets = 6;

  CellSet cells_;
  std::vector<Around> around_;  // by tile
  std::vector<Node> nodes_;     // of every cell of the tiles: to count cells would take longer
  std::array<std::vector<Entry>, kBuckets> buckets_;
};

}  // namespace lasius
