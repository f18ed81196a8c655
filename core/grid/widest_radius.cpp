#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/poller.h"
#include "lasius/clearance.h"

namespace lasius {
namespace {

// The free cells, those of the largest clearance first: as many counts as there are cells suffice,
// since no clearance in half cells is more than the shorter side.
std::vector<std::int32_t> widest_first(const std::vector<std::int32_t>& squared) {
  std::vector<std::int32_t> from(*std::ranges::max_element(squared) + 2);
  for (const std::int32_t s : squared) ++from[s];
  std::int32_t sum = 0;
  for (std::size_t s = from.size() - 1; s > 0; --s) {
    const std::int32_t count = std::exchange(from[s], sum);
    sum += count;
  }
  std::vector<std::int32_t> order(sum);
  for (std::size_t i = 0; i < squared.size(); ++i)
    if (squared[i] > 0) order[from[squared[i]]++] = static_cast<std::int32_t>(i);
  return order;
}

}  // namespace

std::int32_t WidestRadius::root_of(std::int32_t cell) const noexcept {
  while (parent_[cell] >= 0) cell = parent_[cell];
  return cell;
}

std::optional<WidestRadius> WidestRadius::make(const Grid& grid, Corners corners,
                                               const StopCondition& stop) {
  auto field = clearance(grid, stop);
  if (!field) return std::nullopt;
  std::optional<WidestRadius> made = WidestRadius();
  made->field_ = std::move(*field);
  const auto& squared = made->field_.squared_half_cells;
  auto& parent = made->parent_;
  auto& joined = made->joined_;
  parent.assign(squared.size(), 0);  // 0, of a cell that is not there yet or blocked
  joined.assign(squared.size(), 0);
  Poller poller(stop);
  const int reach = corners == Corners::allow ? 2 : 1;  // steps of a neighbour along both axes
  for (const std::int32_t cell : widest_first(squared)) {
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
        joined[b] = squared[cell];
      }
  }
  return made;
}

std::optional<double> WidestRadius::between(Cell a, Cell b) const noexcept {
  const auto index = [this](Cell c) { return c.y * field_.width + c.x; };
  std::int32_t from = index(a), to = index(b);
  std::int32_t least = std::min(field_.squared_half_cells[from], field_.squared_half_cells[to]);
  while (from != to && least > 0) {
    // Trees were joined from wide to narrow: on the way up the clearance falls.
    std::int32_t& lower = joined_[from] > joined_[to] ? from : to;
    least = std::min(least, joined_[lower]);
    lower = parent_[lower];
  }
  if (least == 0) return std::nullopt;
  // As Growth has it: cells are blocked up to 4 radius^2.
  double radius = std::sqrt(static_cast<double>(least)) / 2;
  while (4 * radius * radius >= least) radius = std::nextafter(radius, 0);
  return radius;
}

}  // namespace lasius
