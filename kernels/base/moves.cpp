#include "kernels/base/moves.h"

#include <cmath>
#include <cstdlib>

namespace lasius::kernels {
namespace {

int sign(int v) noexcept { return (v > 0) - (v < 0); }

}  // namespace

Move make_move(int dx, int dy) noexcept {
  Move move;
  move.to = {static_cast<std::int8_t>(dx), static_cast<std::int8_t>(dy)};
  move.length = std::sqrt(static_cast<double>(dx * dx + dy * dy));
  const int ax = std::abs(dx), ay = std::abs(dy), sx = sign(dx), sy = sign(dy);
  int x = 0, y = 0;  // cells gone along each axis
  const auto offset = [&](int cx, int cy) {
    return Offset{static_cast<std::int8_t>(cx * sx), static_cast<std::int8_t>(cy * sy)};
  };
  // Along the segment from centre to centre, cell by cell.
  while (x < ax || y < ay) {
    // Of the way, the next grid line is at (2x + 1) / (2 ax) along x, (2y + 1) / (2 ay) along y.
    const int next_x = ax == 0 ? 1 : (2 * x + 1) * ay;
    const int next_y = ay == 0 ? 1 : (2 * y + 1) * ax;
    const bool along_x = ay == 0 || (ax != 0 && next_x <= next_y);
    const bool along_y = ax == 0 || (ay != 0 && next_y <= next_x);
    if (along_x && along_y) {
      move.corners[move.corner_count++] = {offset(x + 1, y), offset(x, y + 1)};
    }
    x += along_x;
    y += along_y;
    if (x < ax || y < ay) move.swept[move.swept_count++] = offset(x, y);
  }
  return move;
}

}  // namespace lasius::kernels
