// Cuts the loops out of an ant's walk.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/grid/cell_set.h"
#include "kernels/base/packed_cell.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// The way with the fewest moves from a walk's first to its last cell inside the walk's own cells
/// and further ones that the ant entered.
///
/// Time and memory follow these cells, not the map. Buffers are reused; one object per thread.
class LoopCutter {
 public:
  /// Cuts a walk of at least one cell. Moves are the 4 neighbours, with `diagonal` also the 4
  /// diagonals that `corners` allows on `grid`, straight moves tried first. All that counts is that
  /// such moves lead from the first cell to the last by others. The result holds until the next
  /// call; ties are broken by a fixed order. Empty when told to stop before the way was found.
  std::span<const Cell> cut(const Grid& grid, std::span<const Cell> walk, bool diagonal = false,
                            Corners corners = Corners::forbid, const StopCondition& stop = {},
                            std::span<const kernels::PackedCell> further = {});

  /// The walk's cells and the further ones; some of them only, where `cut` was stopped.
  CellSet& entered() noexcept { return entered_; }

  std::int64_t bytes() const noexcept {  ///< memory held
    return entered_.bytes() + held_bytes(tiles_, queue_, way_);
  }

 private:
  /// What the search knows of a tile of the set.
  struct Tile {
    std::uint64_t unseen;    // cells that the search has not reached
    std::uint64_t moves[3];  // the move that reached a cell, a bit plane each
    std::int32_t around[8];  // the tiles next to it, by move
  };
  /// A cell on the search's queue.
  struct Entry {
    std::int32_t tile;
    std::int32_t bit;
  };

  bool collect(std::span<const Cell> walk, std::span<const kernels::PackedCell> further, int moves,
               const StopCondition& stop);
  bool allowed(const Grid& grid, Corners corners, Entry e, int move) const noexcept;
  Cell cell_of(Entry e) const noexcept { return entered_.tiles()[e.tile].cell(e.bit); }

  CellSet entered_;
  std::vector<Tile> tiles_;  // by index in the set
  std::vector<Entry> queue_;
  std::vector<Cell> way_;
};

}  // namespace lasius
