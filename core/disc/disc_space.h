// Where the centre of a disc may be on a bitmap, exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/disc/arc.h"
#include "core/disc/bit_rows.h"
#include "core/disc/disc_cells.h"
#include "core/grid/components.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::disc {

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
/// A map of w x h cells takes 0.7 w h bytes, 4 for each cell of the band, 24 for each arc and 4 for
/// each that passes a cell where several do. Nothing is random, nothing depends on threads. Const
/// members may be called by several threads at once.
class DiscSpace {
 public:
  /// Takes the map. Empty if stopped; the map is as it was then.
  /// @throws Error(invalid_parameter) unless kLeastRadius <= radius <= kLargestRadius
  static std::optional<DiscSpace> make(Grid&& grid, double radius, const StopCondition& stop = {});
  static std::optional<DiscSpace> make(const Grid& grid, double radius,
                                       const StopCondition& stop = {}) {
    return make(Grid(grid), radius, stop);
  }

  /// Takes cells of the map as they are in an edited one of the same size, and makes anew what is
  /// within about twice the radius of them; `changed` has all that differ, and may have others. All
  /// answers become those of a DiscSpace made for the edited map; only arcs have other numbers.
  /// False when stopped: then nothing may be asked.
  bool update(const Grid& edited, std::span<const Cell> changed, const StopCondition& stop = {});

  /// That the disc is planned with: kRadiusMargin less than was asked for.
  double radius() const noexcept { return radius_; }
  double asked_radius() const noexcept { return asked_radius_; }
  const Grid& map() const noexcept { return map_; }
  /// The cells without any free point, as a bitmap.
  const Grid& blocked_cells() const noexcept { return blocked_; }
  /// The cells of the band, likewise.
  const Grid& band_cells() const noexcept { return band_; }
  /// The cells of the band: some of their points are free, or all that are free lie on their edge.
  bool in_band(Cell c) const noexcept { return bit(band_, c.x, c.y); }

  /// May the disc's centre be here? Looks at the cells within the radius.
  bool clear(Point p) const noexcept;
  /// The distance from a point to the nearest blocked cell or the outside, as far as `most` cells,
  /// which is at most kLargestRadius + 1; 0 in blocked cells and outside.
  double clearance(Point p, double most) const noexcept;
  /// May it move straight from a to b? Both are clear.
  bool sees(Point a, Point b) const noexcept { return keeps(a, b, true, kSlack); }
  /// The same where only a is known to be clear.
  bool reaches(Point a, Point b) const noexcept { return keeps(a, b, false, kSlack); }
  /// The same of a polyline, whose first point is known to be clear.
  bool reaches_along(std::span<const Point> path) const noexcept {
    for (std::size_t i = 1; i < path.size(); ++i)
      if (!reaches(path[i - 1], path[i])) return false;
    return true;
  }
  /// As reaches() with room for what is made of it.
  bool reaches_well(Point a, Point b) const noexcept { return keeps(a, b, false, 0.5 * kSlack); }
  /// False proves that it cannot go from a to b, both clear, by any way. True where cells that are
  /// not blocked, 4-connected, lead there: nearly always there is a way then.
  bool joined(Point a, Point b) const noexcept;
  /// The cell of the map that a point lies in, or on whose border.
  Cell cell_at(Point p) const noexcept;
  /// The clear point nearest to a point, of those that are joined() to `other`, if given, and are
  /// taken, if that is asked; nothing if there is none, or when stopped. What is taken is to be
  /// what a straight leg leads to that is nowhere nearer to what is blocked than `p`.
  std::optional<Point> way_out(Point p, Poller& poller, const std::optional<Point>& other = {},
                               const std::function<bool(Point)>& taken = {}) const;

  std::int64_t bytes() const noexcept;  ///< memory held

  // What searches work on.
  std::span<const Arc> arcs() const noexcept { return arcs_; }
  /// Numbers of the arcs that pass a cell of the band.
  std::span<const std::uint32_t> arcs_at(int x, int y) const noexcept {
    const std::uint32_t& cell = cells_[band_number(x, y)];
    if (cell < kSeveral) return {&cell, 1};
    const std::uint32_t* list = passing_.data() + (cell - kSeveral);
    return {list + 1, *list};
  }
  /// A bit for each 8 x 8 cells: set where one of them is not free.
  const Grid& crowded() const noexcept { return crowded_; }
  /// Rows of bits, of the cells that arcs pass: of types 0 and 3, or 1 and 2. Laid out as a Grid's,
  /// but for the bits around the map, which mean nothing.
  const Grid& arc_cells(std::uint32_t type) const noexcept {
    return type == 0 || type == 3 ? arc_cells_even_ : arc_cells_odd_;
  }

 private:
  friend class BandCells;
  friend class SpaceBuilder;

  // A cell of the band is the number of the arc that passes it, or kSeveral and where the list of
  // its arcs is in passing_: their number, then theirs. The first list is the empty one.
  static constexpr std::uint32_t kSeveral = std::uint32_t{1} << 31;
  struct Box {
    double left, top, right, bottom;
  };

  DiscSpace(Grid&& grid, double radius);

  static bool bit(const Grid& plane, int x, int y) noexcept {
    return (plane.row(y)[x >> 6] >> (x & 63) & 1) != 0;
  }
  std::size_t block(int word, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.words()) +
           static_cast<std::size_t>(word);
  }
  std::uint64_t band_in(int word, int y) const noexcept {  // without the bits past the width
    const int columns = map_.width() - 64 * word;
    return band_.row(y)[word] &
           (columns < 64 ? (std::uint64_t{1} << columns) - 1 : ~std::uint64_t{0});
  }
  std::size_t band_number(int x, int y) const noexcept {
    const std::uint64_t before = band_.row(y)[x >> 6] & ((std::uint64_t{1} << (x & 63)) - 1);
    return starts_[block(x >> 6, y)] + count_bits(before);
  }
  std::uint32_t* mutable_arcs_at(int x, int y) noexcept {
    return const_cast<std::uint32_t*>(arcs_at(x, y).data());
  }
  // Blocked cells `wall_` steps left, above, right and below, by bit: none is nearer.
  unsigned walls(int x, int y) const noexcept {
    return (bit(map_, x - wall_, y) ? 1u : 0u) | (bit(map_, x, y - wall_) ? 2u : 0u) |
           (bit(map_, x + wall_, y) ? 4u : 0u) | (bit(map_, x, y + wall_) ? 8u : 0u);
  }
  Box box_of(unsigned walls, int x, int y) const noexcept;
  void compact();
  struct Segment;
  bool keeps(Point a, Point b, bool clear_ends, double slack) const noexcept;
  bool keeps_cell(const Segment& segment, int x, int y, double left, double right) const noexcept;
  bool keeps_row(const Segment& segment, int y, double low_x, double high_x) const noexcept;
  struct Nearest;
  Box inner_box(Cell cell) const noexcept;
  Point end_of(const Arc& arc, double end) const noexcept;
  void nearest_in(Cell cell, Nearest& nearest) const;
  void nearest_along(Point direction, double place, Nearest& nearest) const;
  void nearest_past(Point corner, double clearance, Nearest& nearest) const;

  double asked_radius_;
  double radius_;
  Grid map_;
  Grid blocked_;
  Grid band_;
  Grid arc_cells_even_, arc_cells_odd_;
  Grid crowded_;
  int wall_;  // the least steps to a blocked cell straight away that leave a cell some points
  std::vector<std::uint32_t> starts_;      // of each word of a row: where its band stands in cells_
  std::vector<std::uint32_t> cells_;       // of the band, those of eight rows of a word in a row
  std::vector<std::uint32_t> passing_{0};  // lists of arcs, as many as the first number says
  std::vector<Arc> arcs_;
  std::size_t waste_ = 0;                 // of cells_ and passing_, by edits
  std::optional<Components> components_;  // of the cells that are not blocked
};

}  // namespace lasius::disc
