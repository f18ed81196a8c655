#include "core/grid/grow_obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/grid/changed_parts.h"
#include "lasius/grid/clearance.h"

namespace lasius {
namespace {

// Walks down the rows and knows, for every column, the blocked cells nearest above and below
// within `reach` rows. Rows -1 and `height` are blocked.
class NearestRows {
 public:
  NearestRows(const Grid& grid, int reach, const StopCondition& stop)
      : grid_(grid),
        reach_(reach),
        above_(grid.width(), -1),
        below_(grid.width(), -1),
        poller_(stop, kQuarter) {}

  /// False when stopped.
  bool advance(int y) {
    y_ = y;
    int looked = 0;  // cells, not yet told to the poller
    const std::int64_t newest = std::int64_t{y} + reach_;
    for (int x = 0; x < grid_.width(); ++x) {
      if (below_[x] == kNone) {
        if (newest <= grid_.height() && blocked(x, static_cast<int>(newest)))
          below_[x] = static_cast<int>(newest);
      } else if (below_[x] < y) {
        // All rows are looked at once only: after a free run was searched in vain, only the newest.
        const int last = static_cast<int>(std::min<std::int64_t>(newest, grid_.height()));
        below_[x] = search(x, y, last);
        looked += std::min(below_[x], last) - y + 1;
        if (looked >= kQuarter && poller_.stop_after(std::exchange(looked, 0))) return false;
      }
      if (below_[x] == y) above_[x] = y;
    }
    return !poller_.stop_after(looked + grid_.width());
  }
  /// Rows to the nearest blocked cell of the column, more than `reach` where there is none so near.
  int distance(int x) const noexcept {
    const int up = y_ - above_[x];
    return below_[x] == kNone ? up : std::min(up, below_[x] - y_);
  }

 private:
  static constexpr int kNone = std::numeric_limits<int>::max();
  // Of what may be looked at between two polls. The widest row or highest column is two quarters:
  // with a quarter not yet told and one that the poller waits for, never more than the whole.
  static constexpr int kQuarter = Poller::kWords / 4;

  bool blocked(int x, int y) const noexcept { return (grid_.row(y)[x >> 6] >> (x & 63) & 1) != 0; }
  int search(int x, int from, int to) const noexcept {
    for (int y = from; y <= to; ++y)
      if (blocked(x, y)) return y;
    return kNone;
  }

  const Grid& grid_;
  int reach_;
  int y_ = -1;
  std::vector<int> above_;
  std::vector<int> below_;
  Poller poller_;
};

}  // namespace

std::int64_t largest_below_square(double radius) noexcept {
  const double square = radius * radius;
  const double error = std::fma(radius, radius, -square);
  const bool above = square != std::floor(square) || error > 0;  // the square as it is, unrounded
  return static_cast<std::int64_t>(std::floor(square)) - (above ? 0 : 1);
}

// Two cells that are so many columns and rows apart are max(0, columns - 1) and max(0, rows - 1)
// from each other, the centre of one max(0, columns - 1/2) and max(0, rows - 1/2) from the other:
// less than the radius where the sum of the squares, of centres in half cells, is at most `limit`.
Growth::Growth(const Grid& grid, double radius, ClearanceOf of) {
  require_parameter(radius >= 0 && std::isfinite(radius), "radius", radius,
                    "it must be 0 or more cells");
  if (radius == 0) {
    columns_.push_back(0);
    return;
  }
  // Past the longest side everything is blocked, and nothing overflows.
  const double reach = std::min(radius, static_cast<double>(2 * Grid::kMaxSide));
  const int parts = of == ClearanceOf::centres ? 2 : 1;  // of a cell
  const auto limit = std::max<std::int64_t>(0, largest_below_square(parts * reach));
  for (std::int64_t rows = 0; rows <= grid.height(); ++rows) {
    const std::int64_t up = std::max<std::int64_t>(0, parts * rows - 1);
    if (up * up > limit) break;
    // The root is right to the last bit for numbers below 2^52.
    const auto across = static_cast<std::int64_t>(std::sqrt(static_cast<double>(limit - up * up)));
    columns_.push_back(static_cast<int>((across + 1) / parts));
  }
}

bool Growth::blocked(const Grid& map, Cell cell) const noexcept {
  for (int rows = -reach(); rows <= reach(); ++rows) {
    const int y = cell.y + rows;
    const int columns = columns_[static_cast<std::size_t>(std::abs(rows))];
    const int low = cell.x - columns, high = cell.x + columns;
    if (y < 0 || y >= map.height() || low < 0 || high >= map.width()) return true;
    if (!kernels::row_free(map.row(y), low, high)) return true;
  }
  return false;
}

Grid grow_obstacles(const Grid& grid, double radius) { return *grow_obstacles(grid, radius, {}); }

std::optional<Grid> grow_obstacles(const Grid& grid, double radius, const StopCondition& stop) {
  return grow_obstacles(grid, Growth(grid, radius), stop);
}

std::optional<Grid> grow_obstacles(const Grid& grid, const Growth& growth,
                                   const StopCondition& stop) {
  const std::vector<int>& spans = growth.columns_by_row();
  const int reach = growth.reach();
  const int width = grid.width();
  NearestRows nearest(grid, reach, stop);
  std::vector<int> span(width);
  std::vector<std::uint64_t> words(grid.words());
  std::optional<Grid> grown(std::in_place, width, grid.height());
  for (int y = 0; y < grid.height(); ++y) {
    if (!nearest.advance(y)) return std::nullopt;
    std::ranges::fill(words, 0);
    int covered_to = -1 + spans[0];  // by the outside, and by the columns passed
    for (int x = 0; x < width; ++x) {
      const int rows = nearest.distance(x);
      span[x] = rows <= reach ? spans[rows] : -1;
      covered_to = std::max(covered_to, x + span[x]);
      words[x >> 6] |= std::uint64_t{x <= covered_to} << (x & 63);
    }
    int covered_from = width - spans[0];
    for (int x = width - 1; x >= 0; --x) {
      covered_from = std::min(covered_from, x - span[x]);
      words[x >> 6] |= std::uint64_t{x >= covered_from} << (x & 63);
    }
    grown->set_row(y, words.data());
  }
  return grown;
}

bool regrow(const Grid& map, const Growth& growth, std::span<const Cell> changed, Grid& grown,
            std::vector<Rectangle>& parts, const StopCondition& stop) {
  const int reach = growth.reach();
  const ChangedParts found = parts_of(changed, 2 * reach, map);
  if (found.most) {
    auto anew = grow_obstacles(map, growth, stop);
    if (!anew) return false;
    grown = *std::move(anew);
    parts.push_back({0, 0, map.width(), map.height()});
    return true;
  }
  for (const auto& part : found.parts) {
    const Rectangle inner = widened(part.cells, reach, map), outer = widened(inner, reach, map);
    const Grid around(outer.width, outer.height, map.bytes(outer, Nonzero::blocked),
                      Nonzero::blocked);
    const Grid anew = *grow_obstacles(around, growth, {});
    const Rectangle in_part{inner.x - outer.x, inner.y - outer.y, inner.width, inner.height};
    grown.paste(inner, anew.bytes(in_part, Nonzero::blocked), Nonzero::blocked);
    parts.push_back(inner);
  }
  return true;
}

}  // namespace lasius
