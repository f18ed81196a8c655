// Obstacles grown by a radius, cell by cell and where a map has changed.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "core/grid/clearance.h"
#include "kernels/sight/sight.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// The largest whole number that is less than the square of a number of [0, 2^26], exactly.
std::int64_t largest_below_square(double radius) noexcept;

/// Which cells a blocked one blocks: as grow_obstacles() has it those that have a point nearer to
/// it than the radius, or those whose centre is.
class Growth {
 public:
  /// @throws Error(invalid_parameter) for a negative or not finite radius.
  Growth(const Grid& grid, double radius, ClearanceOf of = ClearanceOf::cells);

  /// How many columns to each side a blocked cell k rows away blocks, by k.
  const std::vector<int>& columns_by_row() const noexcept { return columns_; }
  /// Rows, and columns, that it reaches to each side.
  int reach() const noexcept { return static_cast<int>(columns_.size()) - 1; }
  /// True when one of two cells is blocked if the other one is.
  bool blocks(Cell a, Cell b) const noexcept {
    const int rows = std::abs(a.y - b.y);
    return rows <= reach() && std::abs(a.x - b.x) <= columns_[static_cast<std::size_t>(rows)];
  }
  /// True when a cell of the map is blocked in the grown one: by a blocked cell or by the outside.
  bool blocked(const Grid& map, Cell cell) const noexcept;

 private:
  std::vector<int> columns_;
};

/// All cells that are blocked then. Empty if stopped.
std::optional<Grid> grow_obstacles(const Grid& grid, const Growth& growth,
                                   const StopCondition& stop);

/// Brings a grown map up to date where cells of the map have changed. False if stopped.
/// @param parts  gets rectangles that hold all cells of `grown` that changed
bool regrow(const Grid& map, const Growth& growth, std::span<const Cell> changed, Grid& grown,
            std::vector<Rectangle>& parts, const StopCondition& stop);

}  // namespace lasius
