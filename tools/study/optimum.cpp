#include "study/optimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "lasius/path.h"

namespace lasius::study {
namespace {

constexpr std::string_view kExact = "exact";

struct Move {
  int dx, dy;
  double length;
};

/// The eight directions at `reach` cells.
void add_directions(std::vector<Move>& moves, int reach) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (dx != 0 || dy != 0) moves.push_back({dx * reach, dy * reach, reach * std::hypot(dx, dy)});
}

void add_knights(std::vector<Move>& moves) {
  for (const int dy : {-2, -1, 1, 2})
    for (const int dx : {-2, -1, 1, 2})
      if (std::abs(dx) != std::abs(dy)) moves.push_back({dx, dy, std::sqrt(5.0)});
}

std::vector<Move> moves_of(std::string_view neighbours) {
  if (neighbours == "4") return {{0, -1, 1}, {-1, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const bool square = neighbours == "24" || neighbours == "32";
  std::vector<Move> moves;
  add_directions(moves, 1);
  if (square || neighbours == "16") add_directions(moves, 2);
  if (square || neighbours == "16k") add_knights(moves);
  if (neighbours == "32") add_directions(moves, 3);
  return moves;
}

bool step_allowed(const Grid& grid, Cell at, int dx, int dy, Corners corners) {
  if (grid.blocked({at.x + dx, at.y + dy})) return false;
  if (dx == 0 || dy == 0 || corners == Corners::allow) return true;
  const bool beside = grid.free({at.x + dx, at.y}), above = grid.free({at.x, at.y + dy});
  return corners == Corners::forbid ? beside && above : beside || above;
}

/// Straight and diagonal moves step by step under the rule of corners; a knight's move passes if
/// the two cells that it sweeps are free.
bool allowed(const Grid& grid, Cell at, const Move& move, Corners corners) {
  const int reach = std::gcd(move.dx, move.dy);
  const int dx = move.dx / reach, dy = move.dy / reach;
  if (dx * dx + dy * dy <= 2) {
    for (int i = 0; i < reach; ++i)
      if (!step_allowed(grid, {at.x + i * dx, at.y + i * dy}, dx, dy, corners)) return false;
    return true;
  }
  return visible(grid, at, {at.x + move.dx, at.y + move.dy});
}

}  // namespace

std::optional<double> shortest_by_moves(const Grid& grid, Cell start, Cell goal,
                                        std::string_view neighbours, Corners corners) {
  if (grid.blocked(start) || grid.blocked(goal)) return std::nullopt;
  const auto moves = moves_of(neighbours);
  const auto index = [&](Cell c) {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(grid.width()) +
           static_cast<std::size_t>(c.x);
  };
  struct Reached {
    double length;
    Cell at;
    bool operator<(const Reached& other) const { return length > other.length; }
  };
  std::vector<double> best(index({0, grid.height()}), std::numeric_limits<double>::infinity());
  std::priority_queue<Reached> open;
  best[index(start)] = 0;
  open.push({0, start});
  while (!open.empty()) {
    const auto [length, at] = open.top();
    open.pop();
    if (at == goal) return length;
    if (length > best[index(at)]) continue;
    for (const Move& move : moves) {
      const Cell next{at.x + move.dx, at.y + move.dy};
      if (!allowed(grid, at, move, corners) || length + move.length >= best[index(next)]) continue;
      best[index(next)] = length + move.length;
      open.push({length + move.length, next});
    }
  }
  return std::nullopt;
}

std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Truth& truth, const StopCondition& stop) {
  if (truth.kind == Truth::Kind::moves)
    return shortest_by_moves(planner.grid(), question.start, question.goal, truth.neighbours,
                             truth.corners);
  const auto all = algorithms();
  if (std::none_of(all.begin(), all.end(), [](const Algorithm& a) { return a.name == kExact; }))
    return std::nullopt;
  const Result result = planner.plan({question.start, question.goal, stop}, defaults(kExact));
  if (!result.optimal) return std::nullopt;
  return result.length;
}

}  // namespace lasius::study
