// How the free space of a disc is made: cell by cell in the band, then arc by arc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/disc/disc_space.h"
#include "core/disc/grown_rows.h"

namespace lasius::disc {

/// The lattice points of a map with exactly one blocked cell around them, by type.
class CornerRows {
 public:
  explicit CornerRows(const Grid& grid);

  struct Corner {
    std::uint16_t x, y;
    std::uint32_t type;
  };
  const std::vector<Corner>& corners() const noexcept { return corners_; }
  /// The number of a corner.
  std::uint32_t number(int x, int y) const noexcept;
  /// 64 bits from lattice point (x, y) on, -64 <= x: corners of a type. Rows outside have none.
  std::uint64_t window(std::uint32_t type, int x, int y) const noexcept;

 private:
  std::size_t at(int y) const noexcept { return static_cast<std::size_t>(y) * stride_ + 1; }

  int height_;
  std::size_t stride_;  // words a row, one of them before its first
  std::array<std::vector<std::uint64_t>, 4> rows_;
  std::vector<std::uint32_t> ranks_;  // corners before a word, of any type
  std::vector<Corner> corners_;
};

class SpaceBuilder {
 public:
  SpaceBuilder(DiscSpace& space, Poller& poller);
  /// False if stopped.
  bool build();

 private:
  // A part of a circle in a cell.
  struct Piece {
    std::uint32_t corner;
    double low, high;
  };
  // A circle that bounds what is free of the cell in hand, which lies in its quadrant.
  struct Circle {
    int x, y;
    std::uint32_t type;
  };
  struct Span {
    double low, high;
  };

  void build_tiles(int y0, const GrownRows& grown);
  bool build_cell(int x, int y);
  std::uint32_t steps_to_blocked(int x, int y) const noexcept;
  void find_circles(int x, int y);
  bool outside_circles(Point p) const noexcept;
  bool add_pieces(const Circle& circle, const DiscSpace::Box& box);
  Span span_in(const Circle& circle, const DiscSpace::Box& box) const noexcept;
  void cut(const Circle& circle, const Circle& other);
  void join_pieces();
  std::vector<std::uint32_t> by_tiles() const;

  DiscSpace& space_;
  Poller& poller_;
  const double radius_;
  const double least_square_;  // of a distance that is enough
  Reach reach_;
  CornerRows corners_;
  Grid columns_;  // the map with rows and columns swapped
  using RowBits = std::vector<std::uint64_t>;
  std::array<RowBits, 4> rows_;  // of eight rows: blocked, band, arcs of even types, of odd ones
  std::vector<Circle> circles_;
  std::vector<Span> spans_, cut_spans_;
  std::vector<Piece> pieces_;
};

}  // namespace lasius::disc
