// Whether a robot gets on.
#pragma once

#include <cstdint>

#include "lasius/grid/grid.h"

namespace lasius {

/// Counts the ticks since a robot was last in a cell that it had not been in before.
class Headway {
 public:
  static constexpr int kLongWait = 1 << 14;  ///< ticks

  Headway(int width, int height) : been_(width, height) {}

  /// One more tick. The count begins anew where the world `changed`, moving obstacles aside; a tick
  /// in which the robot is still `planning` does not count.
  void count(Cell cell, bool changed, bool planning) {
    const bool entered = been_.free(cell);
    been_.set_blocked(cell, true);
    cells_ += entered;
    if (entered || changed)
      ticks_ = 0;
    else if (!planning)
      ++ticks_;
  }
  /// True once the robot has entered no new cell for a long wait, and 16 ticks more for each cell
  /// that it has been in.
  bool none() const noexcept { return ticks_ > kLongWait + 16 * cells_; }

 private:
  Grid been_;               // blocked where it was
  std::int64_t cells_ = 0;  // of them
  std::int64_t ticks_ = 0;  // that count, since it entered the last of them
};

}  // namespace lasius
