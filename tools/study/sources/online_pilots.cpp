#include "tools/study/sources/online_pilots.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lasius/shortest_walk.h"

namespace lasius::study {

void ForgetfulPilot::observe(const Rectangle& part, bool blocked) {
  navigator_.observe(part, blocked);
  changed_ = true;
}
void ForgetfulPilot::observe(std::span<const Cell> cells, bool blocked) {
  navigator_.observe(cells, blocked);
  changed_ = changed_ || !cells.empty();
}
const Way& ForgetfulPilot::step(Cell robot, const StopCondition& stop) {
  if (changed_) navigator_.forget();
  changed_ = false;
  return navigator_.step(robot, stop);
}

void DStarPilot::observe(const Rectangle& part, bool blocked) {
  std::vector<Cell> cells;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) cells.push_back({x, y});
  observe(cells, blocked);
}
void DStarPilot::observe(std::span<const Cell> cells, bool blocked) {
  std::vector<Cell> news;
  std::ranges::copy_if(cells, std::back_inserter(news), [&](Cell cell) {
    return map_.contains(cell) && map_.blocked(cell) != blocked;
  });
  if (news.empty()) return;
  for (const Cell cell : news) map_.set_blocked(cell, blocked);
  search_.observe(news, blocked);
  changed_ = true;
}
const Way& DStarPilot::step(Cell robot, const StopCondition&) {
  way_ = {};
  way_.replanned = changed_;
  changed_ = false;
  const double length = search_.plan(robot);
  way_.status = std::isinf(length) ? Status::unreachable : Status::solved;
  if (std::isinf(length)) return way_;
  way_.length = length;
  way_.walk = {robot, search_.next()};
  for (const Cell cell : way_.walk) way_.path.push_back({cell.x + 0.5, cell.y + 0.5});
  return way_;
}
bool DStarPilot::connected(Cell a, Cell b) {
  return shortest_walk(map_, a, b, Neighbours::eight).has_value();
}

}  // namespace lasius::study
