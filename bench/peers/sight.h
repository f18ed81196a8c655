// Line of sight between cell centres, for the peers: exact, on bit rows.
#pragma once

#include <cstdint>
#include <utility>

#include "bench/peers/runs.h"
#include "lasius/grid/grid.h"

namespace lasius::peers {

/// True when the segment between the centres of two cells enters no blocked cell and does not
/// squeeze between two diagonally adjacent ones; touching a corner is allowed. Integers only: row
/// by row, the columns that the segment's part in the row crosses.
inline bool clear_line(const Grid& grid, Cell a, Cell b) noexcept {
  if (a.y > b.y) std::swap(a, b);
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  if (dy == 0) {
    return dx >= 0 ? run_free(grid.row(a.y), a.x, b.x) : run_free(grid.row(a.y), b.x, a.x);
  }
  // The segment leaves row a.y + k through x = a.x + 1/2 + dx (2k + 1) / (2 dy), kept as a whole
  // part and a remainder over 2 dy; it is on a lattice point where the remainder is 0.
  const std::int64_t unit = 2 * dy;
  std::int64_t whole = 2 * static_cast<std::int64_t>(a.x) * dy + dy + dx;  // times 1 / (2 dy)
  std::int64_t rest = whole % unit;
  whole /= unit;
  std::int64_t step_rest = (2 * dx) % unit, step_whole = (2 * dx) / unit;
  if (step_rest < 0) {
    step_rest += unit;
    --step_whole;
  }
  const std::uint64_t* row = grid.row(a.y);
  const int stride = grid.stride();
  const auto column_of_exit_right = [](std::int64_t w, std::int64_t r) {
    return r == 0 ? w - 1 : w;
  };
  std::int64_t enter = a.x;  // first column of this row, in the direction of travel
  for (std::int64_t k = 0; k < dy; ++k, row += stride) {
    if (dx >= 0) {
      const std::int64_t leave = column_of_exit_right(whole, rest);
      if (!run_free(row, enter, leave)) return false;
      // Through the lattice point (whole, y + 1): from column whole - 1 to column whole below it.
      if (rest == 0 && ((row[whole >> 6] >> (whole & 63)) & 1) != 0) {
        const std::int64_t below = whole - 1;
        if (((row[stride + (below >> 6)] >> (below & 63)) & 1) != 0) return false;
      }
      enter = whole;
    } else {
      if (!run_free(row, whole, enter)) return false;
      if (rest == 0) {
        const std::int64_t beside = whole - 1;
        if (((row[beside >> 6] >> (beside & 63)) & 1) != 0 &&
            ((row[stride + (whole >> 6)] >> (whole & 63)) & 1) != 0) {
          return false;
        }
        enter = beside;
      } else {
        enter = whole;
      }
    }
    whole += step_whole;
    rest += step_rest;
    if (rest >= unit) {
      rest -= unit;
      ++whole;
    }
  }
  return dx >= 0 ? run_free(row, enter, b.x) : run_free(row, b.x, enter);
}

}  // namespace lasius::peers
