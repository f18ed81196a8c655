#include "core/cost/goal_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/cost/moves.h"

namespace lasius::cost {

GoalField::GoalField(const Terrain& terrain, Cell goal, double least, bool squeezes)
    : terrain_(terrain), goal_(goal), robot_(goal), least_(least), squeezes_(squeezes) {
  const std::size_t cells = static_cast<std::size_t>(terrain.stride()) * (terrain.height() + 2);
  for (GrowingArray<double>* values : {&cost_, &ahead_}) {
    values->grow(cells);
    std::fill_n(values->data(), cells, kInfinity);
  }
  for (int i = 0; i < 8; ++i) step_[i] = std::ptrdiff_t{kDy[i]} * terrain.stride() + kDx[i];
  ahead_.data()[index(goal)] = 0;
  queue(index(goal));
}

/// Between free cells, and past blocked ones only where that is allowed.
bool GoalField::open(std::size_t at, int move) const noexcept {
  const auto free = [&](int i) { return terrain_.at(at + step_[i]) < kInfinity; };
  return free(move) && (move < 4 || squeezes_ || (free(move - 4) && free((move - 3) & 3)));
}
double GoalField::step_cost(std::size_t at, int move) const noexcept {
  return (move < 4 ? 0.5 : 0.5 * kDiagonal) * (terrain_.at(at) + terrain_.at(at + step_[move]));
}
double GoalField::look_ahead(std::size_t at) const noexcept {
  double least = kInfinity;
  if (!(terrain_.at(at) < kInfinity)) return least;
  for (int i = 0; i < 8; ++i)
    if (open(at, i)) least = std::min(least, step_cost(at, i) + cost_.data()[at + step_[i]]);
  return least;
}
/// Of what leads from the robot to a cell: never more, by more than rounding.
double GoalField::estimate(std::size_t at) const noexcept {
  const Cell c = terrain_.cell(at);
  const int dx = std::abs(robot_.x - c.x), dy = std::abs(robot_.y - c.y);
  return least_ * (1 - 1e-12) * (std::max(dx, dy) + (kDiagonal - 1) * std::min(dx, dy));
}
GoalField::Key GoalField::key(std::size_t at) const noexcept {
  const double less = std::min(cost_.data()[at], ahead_.data()[at]);
  return {less + estimate(at) + moved_, less};
}
void GoalField::queue(std::size_t at) {
  if (cost_.data()[at] == ahead_.data()[at]) return;
  heap_.push_back({key(at), static_cast<std::uint32_t>(at)});
  std::ranges::push_heap(heap_, later);
}
/// Whoever changes a cell's costs queues it anew.
bool GoalField::stale(const Entry& entry) const noexcept {
  const double cost = cost_.data()[entry.at], ahead = ahead_.data()[entry.at];
  return cost == ahead || entry.key.second != std::min(cost, ahead);
}
void GoalField::drop_first() {
  std::ranges::pop_heap(heap_, later);
  heap_.pop_back();
}
void GoalField::drop_stale() {
  constexpr std::size_t kFew = 1 << 16;
  if (heap_.size() < 2 * kept_ + kFew) return;
  std::erase_if(heap_, [this](const Entry& entry) { return stale(entry); });
  std::ranges::make_heap(heap_, later);
  kept_ = heap_.size();
}

void GoalField::changed(std::span<const Cell> cells) {
  touched_.clear();
  for (const Cell c : cells)
    for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, terrain_.height() - 1); ++y)
      for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, terrain_.width() - 1); ++x)
        touched_.push_back(static_cast<std::uint32_t>(terrain_.index(x, y)));
  std::ranges::sort(touched_);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  const std::size_t goal = index(goal_);
  for (const std::uint32_t at : touched_) {
    if (at == goal) continue;
    const double ahead = look_ahead(at);
    if (ahead == ahead_.data()[at]) continue;
    ahead_.data()[at] = ahead;
    queue(at);
  }
}

bool GoalField::update(Cell robot, Poller& poller) {
  moved_ += estimate(index(robot));
  robot_ = robot;
  drop_stale();
  double* const cost = cost_.data();
  double* const ahead = ahead_.data();
  const std::size_t here = index(robot), goal = index(goal_);
  while (!heap_.empty()) {
    const Entry first = heap_.front();
    if (stale(first)) {
      drop_first();
      continue;
    }
    if (!(first.key < key(here)) && !(ahead[here] > cost[here])) break;
    if (poller.stop_after(8)) return false;
    const std::size_t at = first.at;
    drop_first();
    if (first.key < key(at)) {
      queue(at);
      continue;
    }
    if (cost[at] > ahead[at]) {
      cost[at] = ahead[at];
      for (int i = 0; i < 8; ++i) {
        if (!open(at, i)) continue;
        const std::size_t from = at + step_[i];
        const double through = step_cost(at, i) + cost[at];
        if (!(through < ahead[from])) continue;
        ahead[from] = through;
        queue(from);
      }
      continue;
    }
    const double before = cost[at];
    cost[at] = kInfinity;
    queue(at);
    for (int i = 0; i < 8; ++i) {
      if (!open(at, i)) continue;
      const std::size_t from = at + step_[i];
      if (from == goal || ahead[from] != step_cost(at, i) + before) continue;
      const double now = look_ahead(from);
      if (now == ahead[from]) continue;
      ahead[from] = now;
      queue(from);
    }
  }
  return true;
}

std::vector<Cell> GoalField::walk() const {
  std::vector<Cell> cells;
  std::size_t at = index(robot_);
  double value = ahead_.data()[at];
  if (!(value < kInfinity)) return cells;
  for (const std::size_t goal = index(goal_); at != goal;) {
    cells.push_back(terrain_.cell(at));
    double least = kInfinity;
    std::size_t next = at;
    for (int i = 0; i < 8; ++i) {
      if (!open(at, i)) continue;
      const double through = step_cost(at, i) + cost_.data()[at + step_[i]];
      if (!(through < least)) continue;
      least = through;
      next = at + step_[i];
    }
    if (!(cost_.data()[next] < value)) return {};
    value = cost_.data()[next];
    at = next;
  }
  cells.push_back(goal_);
  return cells;
}

std::int64_t GoalField::bytes() const noexcept {
  return cost_.bytes() + ahead_.bytes() + held_bytes(heap_, touched_);
}

}  // namespace lasius::cost
