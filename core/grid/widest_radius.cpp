#include <algorithm>
#include <cmath>
#include <utility>

#include "core/grid/clearance.h"
#include "core/grid/grow_obstacles.h"

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

std::int32_t WidestRadius::root_of(std::int32_t cell) const noexcept {
  while (parent_[cell] >= 0) cell = parent_[cell];
  return cell;
}

std::optional<WidestRadius> WidestRadius::make(const Grid& grid, Corners corners,
                                               const StopCondition& stop) {
  Poller poller(stop, Poller::kWords - grid.width());
  auto field = clearance(grid, ClearanceOf::cells, poller);
  if (!field) return std::nullopt;
  std::optional<WidestRadius> made = WidestRadius();
  made->width_ = grid.width();
  auto& levels = made->levels_;
  levels = std::move(field->squared_half_cells);
  for (int y = 0, i = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x, ++i)
      levels[i] = grid.blocked({x, y}) ? 0 : levels[i] / 4 + 1;
  auto& parent = made->parent_;
  auto& joined = made->joined_;
  parent.assign(levels.size(), 0);  // 0, of a cell that is not there yet or blocked
  joined.assign(levels.size(), 0);
  const int reach = corners == Corners::allow ? 2 : 1;  // steps of a neighbour along both axes
  for (const std::int32_t cell : widest_first(levels)) {
    if (poller.stop_after(1)) return std::nullopt;
    parent[cell] = -1;
    const int x = cell % grid.width(), y = cell / grid.width();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (std::abs(dx) + std::abs(dy) > reach || grid.blocked({x + dx, y + dy})) continue;
        const std::int32_t other = cell + dy * grid.width() + dx;
        if (joined[other] == 0 && parent[other] == 0) continue;
        std::int32_t a = made->root_of(cell), b = made->root_of(other);
        if (a == b) continue;
        if (parent[a] > parent[b]) std::swap(a, b);
        parent[a] += parent[b];
        parent[b] = a;
        joined[b] = levels[cell];
      }
  }
  return made;
}

std::optional<double> WidestRadius::between(Cell a, Cell b) const noexcept {
  const auto index = [this](Cell c) { return c.y * width_ + c.x; };
  std::int32_t from = index(a), to = index(b);
  std::int32_t least = std::min(levels_[from], levels_[to]);
  while (from != to && least > 0) {
    // Trees were joined from wide to narrow: on the way up the level falls.
    std::int32_t& lower = joined_[from] > joined_[to] ? from : to;
    least = std::min(least, joined_[lower]);
    lower = parent_[lower];
  }
  if (least == 0) return std::nullopt;
  // As Growth has it: cells are blocked whose squared clearance is less than the radius squared.
  double radius = std::sqrt(static_cast<double>(least - 1));
  while (largest_below_square(radius) >= least - 1) radius = std::nextafter(radius, 0);
  return radius;
}

}  // namespace lasius
