// Cells of the band of a disc's free space, one by one, and the arcs that pass them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/disc/corner_rows.h"
#include "core/disc/disc_space.h"
#include "core/disc/grown_rows.h"

namespace lasius::disc {

class BandCells {
 public:
  /// `part` holds all corners that reach a cell that is added.
  BandCells(DiscSpace& space, const Words& part);

  /// What is in a word of a row.
  struct Bits {
    std::uint64_t blocked = 0, band = 0;
    std::uint64_t even = 0, odd = 0;  ///< arcs of types 0 and 3, of types 1 and 2
  };
  /// Looks at some cells of a word; adds those of the band.
  Bits add_word(const GrownRows& grown, int word, int y, std::uint64_t cells);
  /// Adds a cell and the pieces of arcs in it; false if no point of it is free.
  bool add(int x, int y);

  std::size_t size() const noexcept { return firsts_.size() - 1; }  ///< cells added
  // A part of a circle in a cell.
  struct Piece {
    std::uint32_t corner;
    std::uint32_t arc;  // once they are joined
    double low, high;
  };
  std::span<const Piece> pieces() const noexcept { return pieces_; }
  std::span<const Piece> pieces(std::size_t cell) const noexcept {
    return pieces().subspan(firsts_[cell], firsts_[cell + 1] - firsts_[cell]);
  }
  const CornerRows& corners() const noexcept { return corners_; }

  /// Pieces of one circle that meet are an arc: adds the arcs to the space, corner by corner, each
  /// one's by the angle. They take the last of the `spare` numbers while there are any.
  /// @param only  whether a corner's pieces count, by corner; empty: all do
  void join(const std::vector<char>& only, std::vector<std::uint32_t>& spare, Poller& poller);
  /// A cell as the space holds it; adds its list of arcs, if it has several. The pieces are joined.
  std::uint32_t kept(std::size_t cell);

 private:
  // A circle that bounds what is free of the cell in hand, which lies in its quadrant.
  struct Circle {
    int x, y;
    std::uint32_t type;
  };
  struct Span {
    double low, high;
  };

  void find_circles(int x, int y);
  bool outside_circles(Point p) const noexcept;
  bool add_pieces(const Circle& circle, const DiscSpace::Box& box);
  Span span_in(const Circle& circle, const DiscSpace::Box& box) const noexcept;
  void cut(const Circle& circle, const Circle& other);

  DiscSpace& space_;
  const double radius_;
  const double least_square_;  // of a distance that is enough
  const std::vector<int> covered_;
  const CornerRows corners_;
  std::vector<Circle> circles_;
  std::vector<Span> spans_, cut_spans_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> firsts_{0};  // of the pieces of each cell, and after the last one
};

}  // namespace lasius::disc
