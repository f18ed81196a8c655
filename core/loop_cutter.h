// Cuts the loops out of an ant's walk.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/walk.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius {

/// The way with the fewest moves from a walk's first to its last cell inside the walk's own cells
/// and further ones that the ant entered.
///
/// Cells are kept in tiles of 8 x 8, found through a small hash table: time and memory follow the
/// walk's cells, not the map. Buffers are reused from call to call; one object per thread.
class LoopCutter {
 public:
  /// Cuts a walk of at least one cell. Moves are the 4 neighbours, with `diagonal` also the 4
  /// diagonals that `corners` allows on `grid`, straight moves tried first. All that counts is that
  /// such moves lead from the first cell to the last by others. The result holds until the next
  /// call; ties are broken by a fixed order. Empty when told to stop before the way was found.
  std::span<const Cell> cut(const Grid& grid, std::span<const Cell> walk, bool diagonal = false,
                            Corners corners = Corners::forbid, const StopCondition& stop = {},
                            std::span<const kernels::PackedCell> further = {});

 private:
  /// Cell (x, y) of a tile is bit 8 (y % 8) + x % 8 of its words.
  struct Tile {
    std::uint64_t unseen;    // cells of the walk that the search has not reached
    std::uint64_t moves[3];  // the move that reached a cell, a bit plane each
    std::int32_t around[8];  // the tiles next to it, by move
    std::uint32_t key;       // its column | row << 16
  };
  /// A cell on the search's queue.
  struct Entry {
    std::int32_t tile;
    std::int32_t bit;
  };

  std::size_t slot_of(std::uint32_t key) const noexcept;
  std::int32_t tile_of(std::uint32_t key);
  bool collect(std::span<const Cell> walk, std::span<const kernels::PackedCell> further, int moves,
               const StopCondition& stop);
  bool allowed(const Grid& grid, Corners corners, Entry e, int move) const noexcept;
  Cell cell_of(Entry e) const noexcept;

  std::vector<std::int32_t> slots_;  // open addressing, a power of two, at least half of them free
  std::vector<Tile> tiles_;
  std::vector<Entry> queue_;
  std::vector<Cell> way_;
};

}  // namespace lasius
