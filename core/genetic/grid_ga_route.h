// Greedy walks on a grid, with a way back out of dead ends.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/base/zero_array.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/moves.h"

namespace lasius {

/// The moves of a walk: 4 or 8 neighbours under a rule of corners.
struct RouteMoves {
  int neighbours = 8;
  Corners corners = Corners::forbid;
};

/// Makes walks on a grid. Address space is reserved by area, memory touched only where walks go.
/// One per thread.
class RouteMaker {
 public:
  /// Gets ready for a grid, which must outlive the walks on it.
  void reset(const Grid& grid, const RouteMoves& moves);

  /// Appends to `route` the walk from its last cell to `to`: always to the open neighbour nearest
  /// to it in a straight line, ties in scan order; no cell is entered twice, and where none is open
  /// the walk steps back. False, with `route` as it was, where there is no way or `poller` stops.
  bool extend(std::vector<Cell>& route, Cell to, Poller& poller);

 private:
  bool legal(Cell at, int dx, int dy) const noexcept;
  /// The open neighbour nearest to `to`, or `at` where none is open.
  Cell nearest_open(Cell at, Cell to) const noexcept;
  std::uint64_t& word_of(Cell c) const noexcept {
    return entered_[std::int64_t{c.y} * words_ + (c.x >> 6)];
  }
  bool entered(Cell c) const noexcept { return (word_of(c) >> (c.x & 63) & 1) != 0; }
  void mark(Cell c);
  void forget() noexcept;

  const Grid* grid_ = nullptr;
  RouteMoves moves_;
  int words_ = 0;                     // a row of `entered_`
  std::int64_t room_ = 0;             // words of `entered_`
  ZeroArray<std::uint64_t> entered_;  // a bit a cell
  std::vector<Cell> marked_;          // those whose bit may be set
};

}  // namespace lasius
