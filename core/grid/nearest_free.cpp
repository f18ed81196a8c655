#include "core/grid/nearest_free.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "core/base/poller.h"

namespace lasius {
namespace {

/// The column of the free cell of row y nearest to x, the left one of two, or nothing. x may lie
/// outside.
std::optional<int> nearest_free_in_row(const Grid& grid, int x, int y) {
  const std::uint64_t* row = grid.row(y);
  const int inside = std::clamp(x, 0, grid.width() - 1);
  std::optional<int> left, right;
  std::uint64_t upto = ~std::uint64_t{0} >> (63 - (inside & 63));
  for (int w = inside >> 6; w >= 0 && !left; --w, upto = ~std::uint64_t{0}) {
    if (const std::uint64_t free = ~row[w] & upto) left = w * 64 + 63 - std::countl_zero(free);
  }
  std::uint64_t from = ~std::uint64_t{0} << (inside & 63);
  for (int w = inside >> 6; w < grid.words() && !right; ++w, from = ~std::uint64_t{0}) {
    if (const std::uint64_t free = ~row[w] & from) right = w * 64 + std::countr_zero(free);
  }
  if (!left || !right) return left ? left : right;
  const std::int64_t at = x;  // perhaps far outside
  return std::abs(*right - at) < std::abs(at - *left) ? right : left;
}

}  // namespace

std::optional<Cell> nearest_free(const Grid& grid, Cell c, Poller& poller) {
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
      const auto x = nearest_free_in_row(grid, c.x, static_cast<int>(y));
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
