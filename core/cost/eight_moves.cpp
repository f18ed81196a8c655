#include "core/cost/eight_moves.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/cost/moves.h"

namespace lasius::cost {
namespace {

// A knight's move goes first into the cell that move kOver leads to.
constexpr int kOver[8] = {0, 0, 2, 2, 1, 1, 3, 3};
constexpr double kKnight = 2.23606797749979;

}  // namespace

std::vector<Cell> EightMoves::search(const Terrain& terrain, Cell start, Cell goal, Corners corners,
                                     Poller& poller, bool knights) {
  const std::size_t cells = static_cast<std::size_t>(terrain.stride()) * (terrain.height() + 2);
  cost_.grow(cells);
  from_.grow(cells);
  double* const cost = cost_.data();
  std::uint8_t* const from = from_.data();
  std::fill(cost, cost + cells, kInfinity);
  std::ptrdiff_t step[16];
  for (int i = 0; i < 16; ++i) step[i] = std::ptrdiff_t{kDy[i]} * terrain.stride() + kDx[i];
  // Less than any walk costs, by more than rounding.
  const double least = terrain.least() * (1 - 1e-12);
  const auto left = [&](Cell c) {
    const int dx = std::abs(goal.x - c.x), dy = std::abs(goal.y - c.y);
    if (knights) return least * std::sqrt(static_cast<double>(dx * dx + dy * dy));
    return least * (std::max(dx, dy) + (kDiagonal - 1) * std::min(dx, dy));
  };
  const std::size_t first = terrain.index(start.x, start.y), last = terrain.index(goal.x, goal.y);
  cost[first] = 0;
  queue_.reset(left(start), 0.05 * terrain.least());
  queue_.push(static_cast<std::uint32_t>(first), left(start));
  while (queue_.advance(poller) && queue_.floor() * (1 - 1e-12) < cost[last]) {
    const std::size_t at = queue_.pop();
    // Popped once already at this cost: the sign tells.
    if (std::signbit(cost[at])) continue;
    const double here = cost[at];
    cost[at] = -here;
    if (poller.stop_after(8)) return {};
    if (at == last) {
      cost[last] = here;
      continue;
    }
    const double weight = terrain.at(at);
    const Cell c = terrain.cell(at);
    bool open[8];
    for (int i = 0; i < 4; ++i) open[i] = terrain.at(at + step[i]) < kInfinity;
    for (int i = 4; i < 8; ++i) {
      const int sides = open[i - 4] + open[(i - 3) & 3];
      open[i] = terrain.at(at + step[i]) < kInfinity &&
                (corners == Corners::allow || sides >= (corners == Corners::forbid ? 2 : 1));
    }
    const auto offer = [&](int i, double there) {
      const std::size_t to = at + step[i];
      if (!(there < std::abs(cost[to]))) return;
      const double key = there + left({c.x + kDx[i], c.y + kDy[i]});
      if (key > cost[last]) return;
      cost[to] = there;
      from[to] = static_cast<std::uint8_t>(i);
      queue_.push(static_cast<std::uint32_t>(to), key);
    };
    for (int i = 0; i < 8; ++i) {
      if (!open[i]) continue;
      offer(i, here + (i < 4 ? 0.5 : 0.5 * kDiagonal) * (weight + terrain.at(at + step[i])));
    }
    if (!knights) continue;
    for (int i = 8; i < 16; ++i) {
      const std::ptrdiff_t major = step[kOver[i - 8]];
      if (!open[kOver[i - 8]]) continue;
      const double first_beside = terrain.at(at + major);
      const double beside = terrain.at(at + step[i] - major);
      if (!(beside < kInfinity)) continue;
      const double end = terrain.at(at + step[i]);
      if (end < kInfinity) offer(i, here + 0.25 * kKnight * (weight + first_beside + beside + end));
    }
  }
  std::vector<Cell> walk;
  if (poller.stopped() || !(cost[last] < kInfinity)) return walk;
  for (std::size_t at = last;; at -= step[from[at]]) {
    walk.push_back(terrain.cell(at));
    if (at == first) break;
  }
  std::ranges::reverse(walk);
  return walk;
}

}  // namespace lasius::cost
