// Greedy walks on a grid, with a way back out of dead ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "kernels/base/moves.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// Makes walks on a grid. Address space is reserved by area, memory touched only where walks go.
/// One per thread.
class RouteMaker {
 public:
  /// Gets ready for a grid, which must outlive the walks on it. What a large map's walks touched is
  /// given back. When stopped, another reset is to come before a walk.
  void reset(const Grid& grid, Neighbours neighbours, Corners corners, const StopCondition& stop);

  /// Appends to `route` the walk from its last cell to `to`: always to the open neighbour nearest
  /// to it in a straight line, ties in scan order; no cell is entered twice, and where none is open
  /// the walk steps back. False, with `route` as it was, where there is no way or `poller` stops;
  /// then a reset is to come before the next walk.
  bool extend(std::vector<Cell>& route, Cell to, Poller& poller);

  std::int64_t bytes() const noexcept { return entered_.bytes() + marked_.bytes(); }  ///< held

 private:
  /// The open neighbour nearest to `to`, or `at` where none is open.
  Cell nearest_open(Cell at, Cell to) const noexcept;
  std::int64_t word_of(Cell c) const noexcept { return std::int64_t{c.y} * words_ + (c.x >> 6); }
  bool entered(Cell c) const noexcept { return (entered_[word_of(c)] >> (c.x & 63) & 1) != 0; }
  void mark(Cell c);
  void forget(Poller& poller);

  const Grid* grid_ = nullptr;
  kernels::Moves moves_;
  Corners corners_ = Corners::forbid;
  int words_ = 0;                     // a row of `entered_`
  ZeroArray<std::uint64_t> entered_;  // a bit a cell
  GrowingArray<Cell> marked_;         // those whose bit may be set
  std::size_t marked_count_ = 0;
};

}  // namespace lasius
