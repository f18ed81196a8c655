// Distance to the nearest obstacle, and obstacles grown by a robot's radius.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

class Poller;

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

/// What is blocked nearest to a point.
struct NearestBlocked {
  double distance = 0;  ///< to its square, cells
  Cell cell{};          ///< perhaps outside; any where nothing is as near as `most`
};
/// Of the blocked squares and the outside; O(distance^2).
/// @param at      a point of the map
/// @param most    cells; what is farther is not looked for
/// @param beside  the nearest to any point so far from `at` along each axis
[[nodiscard]] LASIUS_EXPORT NearestBlocked nearest_blocked(const Grid& grid, Point at, double most,
                                                           double beside = 0);

/// With how wide a disc the cells of a map are still joined by walks over cells, as colonies,
/// drives and Planner::passable() have it, for any number of pairs (by its curves:
/// Planner::widest_disc). Made in O(log) and 24 bytes a cell, of which it keeps 20; a question
/// takes O(log of the cells).
class LASIUS_EXPORT WidestRadius {
 public:
  /// Empty if stopped. The rule of corners matters to what a point alone can pass.
  [[nodiscard]] static std::optional<WidestRadius> make(const Grid& grid,
                                                        Corners corners = Corners::forbid,
                                                        const StopCondition& stop = {});
  /// The largest radius in cells, at most 54, with which a walk leads from one to the other: 0
  /// where only a point passes; nothing where they are not joined at all. Precondition: both lie
  /// inside.
  std::optional<double> between(Cell a, Cell b) const noexcept;

 private:
  // Cells are joined as the radius shrinks, the smaller tree under the root of the larger.
  struct Forest {
    std::vector<std::int32_t> parent;  ///< of a root less than 0: its cells
    std::vector<std::int32_t> joined;  ///< level at which it got its parent
  };
  WidestRadius() = default;
  bool plant(Forest& forest, const Grid& grid, int reach, Poller& poller);
  std::int32_t level_between(const Forest& forest, std::int32_t a, std::int32_t b) const noexcept;

  int width_ = 0;
  bool squeezes_ = false;
  std::vector<std::int32_t> levels_;  ///< squared clearance of centres, in half cells; 0: blocked
  Forest four_, eight_;               ///< by the moves between neighbours
};

}  // namespace lasius
