// Cells by what blocked cells around them leave of them for a disc, row by row on bits.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "lasius/grid.h"

namespace lasius::disc {

/// How far a blocked cell reaches: columns to each side, by the number of rows between, -1 for
/// none.
struct Reach {
  explicit Reach(double radius);

  std::vector<int> touched;  ///< some point of these cells is nearer than the radius
  std::vector<int> covered;  ///< all points are
};

/// For each row of a map the cells that blocked cells and the outside touch, and those that one of
/// them covers alone. Rows have `words()` words of a grid's layout, without words around them; bits
/// past the width are set.
class GrownRows {
 public:
  GrownRows(const Grid& grid, const Reach& reach);
  /// False if stopped.
  bool grow(Poller& poller);

  const std::uint64_t* touched(int y) const noexcept { return touched_.data() + at(y); }
  const std::uint64_t* covered(int y) const noexcept { return covered_.data() + at(y); }

 private:
  using Words = std::vector<std::uint64_t>;

  std::int64_t at(int y) const noexcept { return static_cast<std::int64_t>(y) * grid_.words(); }
  void spread(int y);
  void add(const std::vector<int>& columns, int width, int y, Words& rows) const;

  const Grid& grid_;
  const Reach& reach_;
  Words touched_, covered_;
  Words row_, wider_;  // one row, with a word on each side
};

}  // namespace lasius::disc
