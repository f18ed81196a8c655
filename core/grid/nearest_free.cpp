#include "core/grid/nearest_free.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

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

/// The column nearest to x + aside of a free cell of row y that is taken, the left one of two, or
/// nothing where none is at most `most` columns away from x, which may lie outside.
std::optional<int> nearest_in_row(const Grid& grid, const std::uint64_t* row, int x, double aside,
                                  int y, double most, const Taken& taken) {
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
  return within(right) && 1.0 * right - x - aside < 1.0 * x - left + aside ? right : left;
}

/// A squared distance, less the square of what a spot is aside of its centre.
struct Squared {
  std::uint64_t whole;  ///< from centre to centre
  double rest;

  double minus(const Squared& other) const {
    return static_cast<double>(static_cast<std::int64_t>(whole - other.whole)) +
           (rest - other.rest);
  }
};

}  // namespace

std::optional<Cell> nearest_free(const Grid& grid, Spot spot, Poller& poller, const Taken& taken,
                                 const RowOfBits& row_of) {
  auto [c, aside] = spot;
  if (aside.x == -0.5) --c.x, aside.x = 0.5;  // as near to the left column
  std::optional<Cell> best;
  Squared least{std::uint64_t{1} << 63, 0};
  // Rows outwards from the cell's own, the upper one first.
  const std::int64_t above = c.y, below = static_cast<std::int64_t>(grid.height()) - 1 - c.y;
  const std::int64_t last = std::max(above, below);
  for (std::int64_t d = std::max<std::int64_t>({0, -above, -below}); d <= last; ++d) {
    const auto dy = static_cast<std::uint64_t>(d);  // below 2^32: squares add up in 64 bits
    double most = 1e10;
    if (best) {
      // So many columns away, and more: large squares are rounded, and ties go to the upper row.
      const double reach = std::sqrt(static_cast<double>(least.whole) + least.rest) + 1;
      const double down = std::max(0.0, static_cast<double>(d) - 0.5);
      if (down > reach) break;
      most = std::sqrt((reach - down) * (reach + down)) + 1;
    }
    for (const std::int64_t y : {c.y - d, c.y + d}) {
      if (y < 0 || y >= grid.height()) continue;
      const int at = static_cast<int>(y);
      const auto x =
          nearest_in_row(grid, row_of ? row_of(at) : grid.row(at), c.x, aside.x, at, most, taken);
      if (poller.stop_after(grid.words())) return std::nullopt;
      if (!x) continue;
      const double across = 1.0 * *x - c.x, down = 1.0 * at - c.y;
      const auto dx = static_cast<std::uint64_t>(std::abs(across));
      const Squared squared{dx * dx + dy * dy, -2 * (across * aside.x + down * aside.y)};
      const double further = best ? squared.minus(least) : -1;
      if (further > 0 || (further == 0 && y > best->y)) continue;
      least = squared;
      best = Cell{*x, at};
    }
  }
  return best;
}

}  // namespace lasius
