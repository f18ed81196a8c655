// Whether a robot gets on.
#pragma once

#include <algorithm>
#include <cstdint>

#include "lasius/grid.h"

namespace lasius {

/// Where a robot has been.
class Headway {
 public:
  static constexpr int kLongWait = 1 << 14;  ///< ticks

  Headway(int width, int height) : been_(width, height) {}

  void is_at(Cell cell, std::int64_t tick) {
    if (been_.blocked(cell)) return;
    been_.set_blocked(cell, true);
    ++cells_;
    last_ = tick;
  }
  /// That it has long been to and fro between cells that it knows, in a world that is still as it
  /// was at `since`: for more ticks than it takes to look at all of these cells again and again.
  bool none(std::int64_t tick, std::int64_t since) const noexcept {
    constexpr int kRounds = 16;
    return tick - std::max(last_, since) > kLongWait + kRounds * cells_;
  }

 private:
  Grid been_;               // blocked where it was
  std::int64_t cells_ = 0;  // of them
  std::int64_t last_ = 0;   // tick of the last new one
};

}  // namespace lasius
