// Line of sight from one cell along a walk, at a few nanoseconds a step.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/sight/views.h"

namespace lasius::kernels {

/// Which cells of a walk are seen from its first one, up to the first hidden one.
///
/// Equal to `sees_cell` of each cell. The ray to the current cell crosses one free run of
/// each row, and between two rows it crosses where their runs overlap: a window. The windows of
/// all rows up to the k-th bound the slopes of the rays that get past it: a cone. The walk's next
/// cell is seen when it lies in the cone of the rows before it. Two consecutive rays cross the same
/// windows as long as both are free: a blocked cell between them would have to fit in the
/// triangle that they form with one step, which is too thin for it.
class SightCone {
 public:
  /// Looks from a free cell. No cell with a column outside [lo, hi] will be asked for: rows are
  /// scanned no farther.
  void start(const BitmapView& map, int x, int y, int lo, int hi);

  /// True when (x, y), a king's move from the cell asked before (first: from the start), is seen.
  /// All cells asked before must have been seen.
  bool sees_next(int x, int y);

  /// Words scanned since the last call of this function, at least 1 a step.
  std::int64_t take_work() noexcept {
    const std::int64_t work = work_;
    work_ = 0;
    return work;
  }

  std::int64_t bytes() const noexcept {  ///< memory held
    return static_cast<std::int64_t>(rows_.capacity() * sizeof(Row));
  }

 private:
  /// dx / dy of a ray, in half cells, dy > 0 away from the start's row.
  struct Slope {
    std::int32_t dx;
    std::int32_t dy;
  };
  struct Run {
    int lo;
    int hi;
  };
  /// What the rays to one row go through: its run, and the cone of all rows before it.
  struct Row {
    Run run;
    Slope left;
    Slope right;
  };

  Run run_at(int x, int y) noexcept;
  bool open_row(int x, int y, std::size_t k);

  const BitmapView* map_ = nullptr;
  int x_ = 0;
  int y_ = 0;
  int lo_ = 0;
  int hi_ = 0;
  std::vector<Row> rows_;  // [0] the start's row; then away from it, above or below
  std::size_t depth_ = 0;  // last valid row
  std::int64_t work_ = 0;
};

}  // namespace lasius::kernels
