#include "core/grid/nearest_free.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace lasius {
namespace {

constexpr std::uint64_t kFree = ~std::uint64_t{0}, kBlocked = 0;

/// The last column up to x whose cell is as wanted, or -1.
int seek_left(const std::uint64_t* row, int x, std::uint64_t wanted) {
  for (int w = x >> 6; w >= 0; x = w * 64 - 1, --w) {
    const std::uint64_t bits = (row[w] ^ wanted) & ~std::uint64_t{0} >> (63 - (x & 63));
    if (bits != 0) return w * 64 + 63 - std::countl_zero(bits);
  }
  return -1;
}
/// The first from x on; the columns past the last are blocked. -1 where there is none.
int seek_right(const Grid& grid, const std::uint64_t* row, int x, std::uint64_t wanted) {
  for (int w = x >> 6; w < grid.words(); ++w, x = w * 64) {
    const std::uint64_t bits = (row[w] ^ wanted) & ~std::uint64_t{0} << (x & 63);
    if (bits != 0) return w * 64 + std::countr_zero(bits);
  }
  return -1;
}

using Taken = std::function<bool(Cell)>;

/// The column nearest to x of a free cell of row y that is taken, the left one of two, or nothing
/// where none is at most `most` columns away. x may lie outside.
std::optional<int> nearest_in_row(const Grid& grid, const std::uint64_t* row, int x, int y,
                                  double most, const Taken& taken) {
  const auto within = [&](int column) { return column >= 0 && std::abs(1.0 * column - x) <= most; };
  const auto good = [&](int column) { return !taken || taken({column, y}); };
  const int inside = std::clamp(x, 0, grid.width() - 1);
  int left = seek_left(row, inside, kFree);
  int right = seek_right(grid, row, inside, kFree);
  const bool same = left == right;  // one run on both sides
  while (within(left) && !good(left)) left = seek_left(row, seek_left(row, left, kBlocked), kFree);
  if (same && within(left) && left == right) return left;
  const auto skip = [&] {
    const int end = seek_right(grid, row, right, kBlocked);
    right = end < 0 ? -1 : seek_right(grid, row, end, kFree);
  };
  if (same && right >= 0) skip();
  while (within(right) && !good(right)) skip();
  if (!within(left)) return within(right) ? std::optional(right) : std::nullopt;
  const std::int64_t at = x;  // perhaps far outside
  return within(right) && std::abs(right - at) < std::abs(at - left) ? right : left;
}

}  // namespace

std::optional<Cell> nearest_free(const Grid& grid, Cell c, Poller& poller, const Taken& taken,
                                 const RowOfBits& row_of) {
  std::optional<Cell> best;
  std::uint64_t best_squared = std::numeric_limits<std::uint64_t>::max();
  // Rows outwards from the cell's own, the upper one first.
  const std::int64_t above = c.y, below = static_cast<std::int64_t>(grid.height()) - 1 - c.y;
  const std::int64_t last = std::max(above, below);
  for (std::int64_t d = std::max<std::int64_t>({0, -above, -below}); d <= last; ++d) {
    const auto dy = static_cast<std::uint64_t>(d);  // below 2^32: squares add up in 64 bits
    if (dy * dy > best_squared) break;
    for (const std::int64_t y : {c.y - d, c.y + d}) {
      if (y < 0 || y >= grid.height()) continue;
      // A column more: sums of large squares are rounded, and ties go to the upper row.
      const double most = best ? std::sqrt(static_cast<double>(best_squared - dy * dy)) + 1 : 1e10;
      const int at = static_cast<int>(y);
      const auto x = nearest_in_row(grid, row_of ? row_of(at) : grid.row(at), c.x, at, most, taken);
      if (poller.stop_after(grid.words())) return std::nullopt;
      if (!x) continue;
      const auto dx = static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(*x) - c.x));
      const std::uint64_t squared = dx * dx + dy * dy;
      if (squared > best_squared || (squared == best_squared && y > best->y)) continue;
      best_squared = squared;
      best = Cell{*x, static_cast<int>(y)};
    }
  }
  return best;
}

}  // namespace lasius
