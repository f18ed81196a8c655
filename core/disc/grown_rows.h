// Cells by what blocked cells around them leave of them for a disc, row by row on bits.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "lasius/grid/grid.h"

namespace lasius::disc {

/// How far a blocked cell reaches: columns to each side, by rows between, -1 for none.
struct Reach {
  explicit Reach(double radius);

  std::vector<int> touched;  ///< some point of these cells is nearer than the radius
  std::vector<int> covered;  ///< all points are
};

/// A part of a map: rows, and in them words of 64 cells, up to before the last ones.
struct Words {
  int top, bottom;
  int first, last;

  static Words all(const Grid& grid) noexcept { return {0, grid.height(), 0, grid.words()}; }
};

/// For each row of a part of a map the cells that blocked cells and the outside touch, and those
/// that one of them covers alone. Bits past the map's width are set.
class GrownRows {
 public:
  GrownRows(const Grid& grid, Reach reach, const Words& part);
  /// False if stopped.
  bool grow(Poller& poller);

  std::uint64_t touched(int word, int y) const noexcept { return touched_[at(word, y)]; }
  std::uint64_t covered(int word, int y) const noexcept { return covered_[at(word, y)]; }

 private:
  using Rows = std::vector<std::uint64_t>;

  std::size_t at(int word, int y) const noexcept {
    return static_cast<std::size_t>(y - part_.top) * static_cast<std::size_t>(words_) +
           static_cast<std::size_t>(word - part_.first);
  }
  void spread(int y);
  void add(const std::vector<int>& columns, int width, int y, Rows& rows) const;

  const Grid& grid_;
  const Reach reach_;
  const Words part_;
  const int words_;  // of a row
  Rows touched_, covered_;
  Rows row_, wider_;  // one row, with a word on each side
};

}  // namespace lasius::disc
