#include "bench/peers/heap_astar.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <numbers>

namespace lasius::peers {

HeapAStar::HeapAStar(const Grid& grid) : moves_(grid), nodes_(moves_.size(), Node{0, 0, 0}) {}

double HeapAStar::plan(Cell start, Cell goal, std::vector<Point>& path) {
  path.clear();
  heap_.clear();
  ++stamp_;
  const auto estimate = [goal](int x, int y) noexcept {
    const int dx = std::abs(x - goal.x), dy = std::abs(y - goal.y);
    return std::max(dx, dy) + (std::numbers::sqrt2 - 1) * std::min(dx, dy);
  };
  const std::uint32_t start_index = moves_.index(start), goal_index = moves_.index(goal);
  const auto offsets = moves_.offsets();
  nodes_[start_index] = {0, stamp_, 0};
  heap_.push_back({estimate(start.x, start.y), 0, start_index, static_cast<std::uint16_t>(start.x),
                   static_cast<std::uint16_t>(start.y)});
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Item item = heap_.back();
    heap_.pop_back();
    if (item.cost > nodes_[item.index].cost) continue;
    if (item.index == goal_index) break;
    for (unsigned mask = moves_.moves(item.index); mask != 0; mask &= mask - 1) {
      const auto k = static_cast<unsigned>(std::countr_zero(mask));
      const auto next_index = item.index + static_cast<std::uint32_t>(offsets[k]);
      const double cost = item.cost + (k < 4 ? 1.0 : std::numbers::sqrt2);
      Node& next = nodes_[next_index];
      if (next.stamp == stamp_ && next.cost <= cost) continue;
      next = {cost, stamp_, k};
      const int x = item.x + kMoveX[k], y = item.y + kMoveY[k];
      heap_.push_back({cost + estimate(x, y), cost, next_index, static_cast<std::uint16_t>(x),
                       static_cast<std::uint16_t>(y)});
      std::push_heap(heap_.begin(), heap_.end());
    }
  }
  if (nodes_[goal_index].stamp != stamp_) return kNoPath;
  for (Cell c = goal; c != start;) {
    path.push_back(centre(c));
    const std::uint32_t k = nodes_[moves_.index(c)].move;
    c = {c.x - kMoveX[k], c.y - kMoveY[k]};
  }
  path.push_back(centre(start));
  std::reverse(path.begin(), path.end());
  return nodes_[goal_index].cost;
}

}  // namespace lasius::peers
