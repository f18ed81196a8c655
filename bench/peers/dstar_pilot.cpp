#include "bench/peers/dstar_pilot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "lasius/path/shortest_walk.h"

namespace lasius::peers {

void GridPilot::observe(const Rectangle& part, bool blocked) {
  std::vector<Cell> cells;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) cells.push_back({x, y});
  observe(cells, blocked);
}

void GridPilot::observe(std::span<const Cell> cells, bool blocked) {
  std::vector<Cell> news;
  std::ranges::copy_if(cells, std::back_inserter(news), [&](Cell cell) {
    return map_.contains(cell) && map_.blocked(cell) != blocked;
  });
  if (news.empty()) return;
  for (const Cell cell : news) map_.set_blocked(cell, blocked);
  changed(news, blocked);
}

bool GridPilot::connected(Cell a, Cell b) {
  return shortest_walk(map_, a, b, Neighbours::eight).has_value();
}

const Way& GridPilot::tell(double length, std::vector<Cell> walk, bool replanned) {
  way_ = {};
  way_.replanned = replanned;
  way_.status = std::isinf(length) ? Status::unreachable : Status::solved;
  if (std::isinf(length)) return way_;
  way_.length = length;
  way_.walk = std::move(walk);
  for (const Cell cell : way_.walk) way_.path.push_back(centre(cell));
  return way_;
}

void DStarPilot::changed(std::span<const Cell> cells, bool blocked) {
  search_.observe(cells, blocked);
  changed_ = true;
}

const Way& DStarPilot::step(Cell robot, const StopCondition&) {
  const double length = search_.plan(robot);
  return tell(length, {robot, std::isinf(length) ? robot : search_.next()},
              std::exchange(changed_, false));
}

}  // namespace lasius::peers
