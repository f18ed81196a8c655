// Where the centre of a disc may be on a bitmap, exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/disc/arc.h"
#include "core/disc/bit_rows.h"
#include "core/grid/components.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius::disc {

/// The radii that a DiscSpace can be made for, in cells.
constexpr double kLeastRadius = 0.05;
constexpr double kLargestRadius = 54;

/// @throws Error(invalid_parameter) unless kLeastRadius <= radius <= kLargestRadius
void check_disc_radius(double radius);

/// The free space of a disc: all points whose distance to every blocked cell, a closed square, and
/// to what lies outside the map is at least the radius (up to kSlack).
///
/// A cell is free where all of its points are, blocked where none is, else it is in the band, which
/// is about one and a half cells wide. A point of a cell is nearest to a blocked cell straight
/// beside, above or below it, or to a corner (see Arc) that lies diagonally. So what is free of a
/// cell is a box without circles: the box ends a radius away from the nearest blocked cells of its
/// row and column, and where a circle bounds what is free, an arc passes the cell. A segment that
/// begins in free space and leaves it does so through a side of a box or through an arc, in the
/// cell that knows it.
///
/// A map of w x h cells takes 0.88 w h bytes, 8 for each cell of the band, 24 for each arc and 4
/// for each cell with several of them. Nothing is random, nothing depends on threads. Const members
/// may be called by several threads at once.
class DiscSpace {
 public:
  /// Copies the map. Empty if stopped.
  /// @throws Error(invalid_parameter) unless kLeastRadius <= radius <= kLargestRadius
  static std::optional<DiscSpace> make(const Grid& grid, double radius,
                                       const StopCondition& stop = {});

  /// That the disc is planned with: kRadiusMargin less than was asked for.
  double radius() const noexcept { return radius_; }
  double asked_radius() const noexcept { return asked_radius_; }
  const Grid& map() const noexcept { return map_; }
  /// The cells without any free point, as a bitmap.
  const Grid& blocked_cells() const noexcept { return blocked_; }
  /// The cells of the band: some of their points are free, or all that are free lie on their edge.
  bool in_band(Cell c) const noexcept { return bit(band_, c.x, c.y); }

  /// May the disc's centre be here? Looks at the cells within the radius.
  bool clear(Point p) const noexcept;
  /// The distance from a point to the nearest blocked cell or the outside, as far as `most` cells,
  /// which is at most kLargestRadius + 1; 0 in blocked cells and outside.
  double clearance(Point p, double most) const noexcept;
  /// May it move straight from a to b? Both are clear.
  bool sees(Point a, Point b) const noexcept { return keeps(a, b, true); }
  /// The same where only a is known to be clear.
  bool reaches(Point a, Point b) const noexcept { return keeps(a, b, false); }
  /// False proves that it cannot go from a to b, both clear, by any way. True where cells that are
  /// not blocked, 4-connected, lead there: nearly always there is a way then.
  bool joined(Point a, Point b) const noexcept;
  /// The clear point nearest to a point of the map; nothing if there is none.
  std::optional<Point> way_out(Point p) const;

  std::int64_t bytes() const noexcept;  ///< memory held

  // What searches work on.
  std::span<const Arc> arcs() const noexcept { return arcs_; }
  /// Numbers of the arcs that pass a cell of the band.
  std::span<const std::uint32_t> arcs_at(int x, int y) const noexcept {
    const BandCell& cell = band_cell(x, y);
    const std::uint32_t count = cell.box_and_count >> 24;
    return {count == 1 ? &cell.first : passing_.data() + cell.first, count};
  }
  /// The cells of the band, as a bitmap.
  const Grid& band_cells() const noexcept { return band_; }
  /// A bit for each 8 x 8 cells: set where one of them is not free.
  const Grid& crowded() const noexcept { return crowded_; }
  /// Rows of bits, of the cells that arcs pass: of types 0 and 3, or 1 and 2. Laid out as a Grid's,
  /// but for the bits around the map, which mean nothing.
  const Grid& arc_cells(std::uint32_t type) const noexcept {
    return type == 0 || type == 3 ? arc_cells_even_ : arc_cells_odd_;
  }

 private:
  friend class SpaceBuilder;

  // How far the nearest blocked cells of row and column are, by side (6 bits each: the steps to
  // them, kFar for none within reach), and the number of arcs (8 bits); the one arc, or where
  // several stand in passing_.
  struct BandCell {
    std::uint32_t box_and_count;
    std::uint32_t first;
  };
  static constexpr std::uint32_t kFar = 63;
  // 8 x 8 cells: those of the band, row by row, stand together. So do arcs, by their corners.
  struct Tile {
    std::uint64_t band = 0;
    std::uint32_t first = 0;
  };
  struct Box {
    double left, top, right, bottom;
  };

  DiscSpace(const Grid& grid, double radius)
      : asked_radius_(radius),
        radius_(radius - kRadiusMargin),
        map_(grid),
        blocked_(grid.width(), grid.height()),
        band_(grid.width(), grid.height()),
        arc_cells_even_(grid.width(), grid.height()),
        arc_cells_odd_(grid.width(), grid.height()),
        crowded_((grid.width() + 7) / 8, (grid.height() + 7) / 8),
        tiles_across_((static_cast<std::size_t>(grid.width()) + 7) / 8),
        tiles_(tiles_across_ * ((static_cast<std::size_t>(grid.height()) + 7) / 8)) {}

  static bool bit(const Grid& plane, int x, int y) noexcept {
    return (plane.row(y)[x >> 6] >> (x & 63) & 1) != 0;
  }
  const BandCell& band_cell(int x, int y) const noexcept {
    const Tile& tile = tiles_[static_cast<std::size_t>(y >> 3) * tiles_across_ + (x >> 3)];
    const std::uint64_t below = (std::uint64_t{1} << ((y & 7) << 3 | (x & 7))) - 1;
    return cells_[tile.first + count_bits(tile.band & below)];
  }
  Box box_of(const BandCell& cell, int x, int y) const noexcept;
  struct Segment;
  bool keeps(Point a, Point b, bool clear_ends) const noexcept;
  bool keeps_cell(const Segment& segment, int x, int y, double left, double right) const noexcept;
  bool keeps_row(const Segment& segment, int y, double low_x, double high_x) const noexcept;
  struct Nearest;
  void nearest_in(Cell cell, Nearest& nearest) const;

  double asked_radius_;
  double radius_;
  Grid map_;
  Grid blocked_;
  Grid band_;
  Grid arc_cells_even_, arc_cells_odd_;
  Grid crowded_;
  std::size_t tiles_across_;
  std::vector<Tile> tiles_;
  std::vector<BandCell> cells_;
  std::vector<std::uint32_t> passing_;  // arcs, cell by cell
  std::vector<Arc> arcs_;
  std::optional<Components> components_;  // of the cells that are not blocked
};

}  // namespace lasius::disc
