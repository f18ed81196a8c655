#include <algorithm>
#include <cmath>
#include <utility>

#include "core/grid/clearance.h"

namespace lasius {
namespace {

// The free cells, those of the highest level first: as many counts as there are cells suffice,
// since no clearance is more than half the shorter side.
std::vector<std::int32_t> widest_first(const std::vector<std::int32_t>& levels) {
  std::vector<std::int32_t> from(*std::ranges::max_element(levels) + 2);
  for (const std::int32_t level : levels) ++from[level];
  std::int32_t sum = 0;
  for (std::size_t s = from.size() - 1; s > 0; --s) {
    const std::int32_t count = std::exchange(from[s], sum);
    sum += count;
  }
  std::vector<std::int32_t> order(sum);
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (levels[i] > 0) order[from[levels[i]]++] = static_cast<std::int32_t>(i);
  return order;
}

}  // namespace

bool WidestRadius::plant(Forest& forest, const Grid& grid, int reach, Poller& poller) {
  auto& parent = forest.parent;
  auto& joined = forest.joined;
  parent.assign(levels_.size(), 0);  // 0, of a cell that is not there yet or blocked
  joined.assign(levels_.size(), 0);
  const auto root_of = [&](std::int32_t cell) {
    while (parent[cell] >= 0) cell = parent[cell];
    return cell;
  };
  for (const std::int32_t cell : widest_first(levels_)) {
    if (poller.stop_after(1)) return false;
    parent[cell] = -1;
    const int x = cell % width_, y = cell / width_;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (std::abs(dx) + std::abs(dy) > reach || grid.blocked({x + dx, y + dy})) continue;
        const std::int32_t other = cell + dy * width_ + dx;
        if (joined[other] == 0 && parent[other] == 0) continue;
        std::int32_t a = root_of(cell), b = root_of(other);
        if (a == b) continue;
        if (parent[a] > parent[b]) std::swap(a, b);
        parent[a] += parent[b];
        parent[b] = a;
        joined[b] = levels_[cell];
      }
  }
  return true;
}

std::optional<WidestRadius> WidestRadius::make(const Grid& grid, Corners corners,
                                               const StopCondition& stop) {
  Poller poller(stop, Poller::kWords - grid.width());
  auto field = clearance(grid, ClearanceOf::centres, poller);
  if (!field) return std::nullopt;
  std::optional<WidestRadius> made = WidestRadius();
  made->width_ = grid.width();
  made->squeezes_ = corners == Corners::allow;
  made->levels_ = std::move(field->squared_half_cells);
  if (!made->plant(made->four_, grid, 1, poller) || !made->plant(made->eight_, grid, 2, poller))
    return std::nullopt;
  return made;
}

// The largest squared clearance that all cells of a way keep; 0 where there is none.
std::int32_t WidestRadius::level_between(const Forest& forest, std::int32_t a,
                                         std::int32_t b) const noexcept {
  std::int32_t least = std::min(levels_[a], levels_[b]);
  while (a != b && least > 0) {
    // Trees were joined from wide to narrow: on the way up the level falls, so the higher one goes.
    std::int32_t& higher = forest.joined[a] > forest.joined[b] ? a : b;
    least = std::min(least, forest.joined[higher]);
    higher = forest.parent[higher];
  }
  return least;
}

// A diagonal move may come nearer to a corner than its ends do where the radius r is such that
// k sqrt(2) < r <= sqrt(2 k^2 + 1/2) for a whole k: then only four neighbours count.
std::optional<double> WidestRadius::between(Cell a, Cell b) const noexcept {
  const std::int32_t from = a.y * width_ + a.x, to = b.y * width_ + b.x;
  constexpr std::int32_t kMost = 4 * 54 * 54;
  const std::int32_t eight = std::min(level_between(eight_, from, to), kMost);
  if (eight == 0) return std::nullopt;
  const auto k = static_cast<std::int32_t>(std::sqrt((eight - 1) / 8));
  const std::int32_t below = 8 * k * k;
  if (eight > below + 2) return std::sqrt(1.0 * eight) / 2;
  const std::int32_t four = std::min(level_between(four_, from, to), kMost);
  if (four == 0 && below == 0 && !squeezes_) return std::nullopt;
  return std::sqrt(1.0 * std::max(four, below)) / 2;
}

}  // namespace lasius
