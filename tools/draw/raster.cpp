#include "tools/draw/raster.h"

#include <algorithm>
#include <bit>

namespace lasius::tool {
namespace {

/// Blocked cells in columns [from, to) of one bit row.
int count_blocked(const std::uint64_t* row, int from, int to) {
  int count = 0;
  for (int x = from; x < to;) {
    const int bit = x & 63;
    const int taken = std::min(64 - bit, to - x);
    const std::uint64_t mask = taken == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << taken) - 1;
    count += std::popcount((row[x >> 6] >> bit) & mask);
    x += taken;
  }
  return count;
}

}  // namespace

Window whole(const Grid& grid) { return {{0, grid.width()}, {0, grid.height()}}; }

Span cells_under(int pixel, int pixels, const Span& shown) {
  const auto edge = [&](int p) {
    return shown.from +
           static_cast<int>(static_cast<std::int64_t>(p) * (shown.to - shown.from) / pixels);
  };
  const int from = edge(pixel);
  return {from, std::max(from + 1, edge(pixel + 1))};
}

float blocked_share(const Grid& grid, Span columns, Span rows) {
  int blocked = 0;
  for (int r = rows.from; r < rows.to; ++r)
    blocked += count_blocked(grid.row(r), columns.from, columns.to);
  const int cells = (rows.to - rows.from) * (columns.to - columns.from);
  return static_cast<float>(blocked) / static_cast<float>(cells);
}

Raster<float> blocked_share(const Grid& grid, const Window& window, int width, int height) {
  Raster<float> share(width, height);
  for (int y = 0; y < height; ++y) {
    const Span rows = cells_under(y, height, window.rows);
    for (int x = 0; x < width; ++x)
      share.at(x, y) = blocked_share(grid, cells_under(x, width, window.columns), rows);
  }
  return share;
}

Colour blend(Colour from, Colour to, double share) {
  const auto mix = [share](double a, double b) { return a + (b - a) * share; };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

}  // namespace lasius::tool
