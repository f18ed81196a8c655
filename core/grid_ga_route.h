// Greedy walks on a grid, with a way back out of dead ends.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius {

/// The moves of a walk: 4 or 8 neighbours under a rule of corners.
struct RouteMoves {
  int neighbours = 8;
  Corners corners = Corners::forbid;
};

/// Makes walks on one grid. Address space is reserved by area, memory touched only where walks go.
/// One per thread.
class RouteMaker {
 public:
  RouteMaker(const Grid& grid, const RouteMoves& moves);

  /// Appends to `route` the walk from its last cell to `to`: always to the open neighbour nearest
  /// to it in a straight line, ties in scan order; no cell is entered twice, and where none is open
  /// the walk steps back. False, with `route` as it was, where there is no way or `poller` stops.
  bool extend(std::vector<Cell>& route, Cell to, Poller& poller);

 private:
  struct Free {
    void operator()(std::uint64_t* p) const noexcept;
  };

  bool legal(Cell at, int dx, int dy) const noexcept;
  /// The open neighbour nearest to `to`, or `at` where none is open.
  Cell nearest_open(Cell at, Cell to) const noexcept;
  bool entered(Cell c) const noexcept;
  void mark(Cell c);

  const Grid& grid_;
  RouteMoves moves_;
  std::unique_ptr<std::uint64_t[], Free> entered_;  // a bit a cell
  std::vector<Cell> marked_;
};

}  // namespace lasius
