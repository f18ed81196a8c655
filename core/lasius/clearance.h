// Distance to the nearest obstacle, and obstacles grown by a robot's radius.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lasius/export.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/moves.h"
#include "lasius/stop.h"

namespace lasius {

/// Exact squared Euclidean distances, in half cells, from each cell's centre to the nearest point
/// of a blocked cell's square or of the outside; 0 for blocked cells. Row-major, width x height.
struct ClearanceField {
  int width = 0;                                 ///< of the grid
  int height = 0;                                ///< of the grid
  std::vector<std::int32_t> squared_half_cells;  ///< at most 2^30
  /// Clearance in cells. Precondition: the cell lies inside.
  LASIUS_EXPORT double at(Cell c) const noexcept;
};

/// The clearance of every cell, by lower envelopes of parabolas (Felzenszwalb & Huttenlocher 2012)
/// in integers: O(1) and 4 bytes per cell.
[[nodiscard]] LASIUS_EXPORT ClearanceField clearance(const Grid& grid);
/// The same, or empty if stopped. The measure of work is a cell read, as wide as a word here; what
/// was measured is given back then, in a tenth of a second for each gigabyte.
[[nodiscard]] LASIUS_EXPORT std::optional<ClearanceField> clearance(const Grid& grid,
                                                                    const StopCondition& stop);

/// Blocks every cell that has a point nearer than `radius` cells to a blocked cell (a closed
/// square) or to the outside: whatever is planned on the cells that stay free keeps the radius.
/// That of a cell c columns and r rows away: where max(0, c - 1)^2 + max(0, r - 1)^2 < radius^2.
/// Exact; radius 0 changes nothing. A disc passes more than that: Planner(Grid, Disc) plans `exact`
/// for it. O(1) per cell; beside the grids some rows of memory, whatever the radius.
/// @throws Error(invalid_parameter) for a negative or not finite radius.
[[nodiscard]] LASIUS_EXPORT Grid grow_obstacles(const Grid& grid, double radius);
/// The same, or empty if stopped. The measure of work is a cell looked at; the new bitmap itself is
/// not cut short, 1 ms for 13 million cells.
[[nodiscard]] LASIUS_EXPORT std::optional<Grid> grow_obstacles(const Grid& grid, double radius,
                                                               const StopCondition& stop);

/// With how wide a radius the cells of a map are still joined when obstacles grow by it, for any
/// number of pairs (of a disc by its own rule: Planner::widest_disc). Made in
/// O(log) and 16 bytes a cell, of which it keeps 12; a question takes O(log of the cells).
class LASIUS_EXPORT WidestRadius {
 public:
  /// Under a rule of corners, as Planner::connected has it; empty if stopped.
  [[nodiscard]] static std::optional<WidestRadius> make(const Grid& grid,
                                                        Corners corners = Corners::forbid,
                                                        const StopCondition& stop = {});
  /// The largest radius in cells with which grow_obstacles leaves both cells free and joined, to
  /// the last bit; nothing where they are not, whatever the radius. Precondition: both lie inside.
  std::optional<double> between(Cell a, Cell b) const noexcept;

 private:
  WidestRadius() = default;
  std::int32_t root_of(std::int32_t cell) const noexcept;

  int width_ = 0;
  std::vector<std::int32_t> levels_;  ///< squared clearance of whole cells + 1; 0: blocked
  // A forest: cells are joined as the radius shrinks, the smaller tree under the root of the
  // larger.
  std::vector<std::int32_t> parent_;  ///< of a root less than 0: its cells
  std::vector<std::int32_t> joined_;  ///< level at which it got its parent
};

}  // namespace lasius
