// A corner that a search has reached: its length so far, its parent, and where a path may go on.
#pragma once

#include <cstdint>

namespace lasius::exact {

/// The cone a path may go on in after it turned at a corner: a quadrant given by two signs, and the
/// side of it that the turn is towards.
class Heading {
 public:
  Heading() = default;
  /// Signs of dx and dy; turned towards the vertical line (else towards the horizontal one)?
  constexpr Heading(int right, int down, bool towards_column) noexcept
      : bits_(static_cast<std::uint8_t>((right > 0 ? 1 : 0) | (down > 0 ? 2 : 0) |
                                        (towards_column ? 4 : 0))) {}
  constexpr int right() const noexcept { return (bits_ & 1) * 2 - 1; }
  constexpr int down() const noexcept { return (bits_ & 2) - 1; }
  constexpr bool towards_column() const noexcept { return (bits_ & 4) != 0; }

 private:
  std::uint8_t bits_ = 0;
};

/// A corner of a blocked cell, or the start (index 0), in half-cell coordinates.
struct Corner {
  int x = 0, y = 0;
  double length = 0;   ///< of the shortest known path from the start
  double to_goal = 0;  ///< straight distance
  std::uint32_t parent = 0;
  Heading heading = {};
  bool expanded = false;   ///< its cone was scanned at this length
  bool weighed = false;    ///< the weighted search has expanded it
  std::uint8_t scans = 0;  ///< how often its cone was scanned and cut off, at this length
};
static_assert(sizeof(Corner) == 32);

}  // namespace lasius::exact
