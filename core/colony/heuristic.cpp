#include "core/colony/heuristic.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <queue>
#include <tuple>

#include "core/base/kernel_choice.h"
#include "core/grid/cell_distance.h"
#include "core/grid/move_rule.h"
#include "kernels/base/power.h"
#include "lasius/params/own_rules.h"

namespace lasius {
namespace {

constexpr double kNearest = 0.5;  // cells: the goal itself is not at distance 0 from its weight
constexpr double kLeastBase = 0x1p-100;  // a move that exists has a value, however low

// What the caller counts as less counts as this: its 20th power is still a number of its own.
constexpr double kLeastOwn = 1 / OwnRules::kMostHeuristic;

}  // namespace

void HeuristicRows::reset(const Grid& grid, const kernels::Moves& moves, Cell goal,
                          const Params& params, const StopCondition& stop,
                          std::span<const double> own, const cost::Terrain* terrain) {
  grid_ = &grid;
  terrain_ = terrain;
  own_ = own;
  cells_ = std::int64_t{grid.width()} * grid.height();
  moves_ = moves;
  goal_ = goal;
  params_ = params;
  raise_ = kernels::raise_row(chosen_isa());
  Poller poller(stop);
  if (!distances_.clear(poller)) return;
  distances_ = {};
  if (own.empty() && params.heuristic == Heuristic::distance_field) measure_distances(poller);
}

void HeuristicRows::fill(Cell c, double beta, float* row) const {
  std::fill_n(row, moves_.count, 0.0f);
  if (grid_->blocked(c)) return;
  // Dmax of equation 4 is over all free cells around, whether or not a corner closes the move.
  double farthest = 0;
  if (rescaled()) {
    for (int k = 0; k < moves_.count; ++k) {
      const Cell to = c + moves_[k].to;
      if (grid_->free(to)) farthest = std::max(farthest, distance(to, goal_));
    }
  }
  std::array<bool, kernels::kMaxMoves> exists{};
  std::array<double, kernels::kMaxMoves> values;
  values.fill(1);  // of moves that do not exist: anything that has a power
  for (int k = 0; k < moves_.count; ++k) {
    exists[k] = move_exists(*grid_, params_.corners, c, moves_[k]);
    if (!exists[k]) continue;
    values[k] =
        own_.empty()
            ? std::max(base(c, c + moves_[k].to, farthest) * ease(c + moves_[k].to), kLeastBase)
            : std::max(own(c, k), kLeastOwn);
  }
  raise_(values.data(), moves_.count, rescaled() ? params_.lambda : beta);
  double largest = 0;
  for (int k = 0; k < moves_.count; ++k) {
    if (exists[k]) largest = std::max(largest, values[k]);
  }
  for (int k = 0; k < moves_.count; ++k) {
    if (exists[k]) row[k] = static_cast<float>(std::max(values[k] / largest, kSmallest));
  }
}

double HeuristicRows::ease(Cell to) const noexcept {
  return terrain_ != nullptr ? terrain_->least() / terrain_->weight(to.x, to.y) : 1;
}

double HeuristicRows::base(Cell c, Cell to, double farthest) const noexcept {
  switch (params_.heuristic) {
    case Heuristic::uniform:
    case Heuristic::learned:
      break;
    case Heuristic::rescaled_distance:
      return (farthest - distance(to, goal_)) * params_.omega + params_.mu;
    case Heuristic::inverse_distance:
      return 1 / std::max(distance(to, goal_), kNearest);
    case Heuristic::distance:
      return std::max(distance(to, goal_), kNearest);
    case Heuristic::goal_angle: {
      const double h = kernels::angle_between(to.x - c.x, to.y - c.y, goal_.x - c.x, goal_.y - c.y);
      return 1 / (1 + h / (std::numbers::pi / 4));
    }
    case Heuristic::distance_field: {
      const double d = distances_[static_cast<std::int64_t>(to.y) * grid_->width() + to.x];
      return 1 / std::max(d, kNearest);
    }
  }
  return 1;
}

double HeuristicRows::own(Cell c, int move) const noexcept {
  const bool per_cell = std::ssize(own_) == cells_;
  const Cell at = per_cell ? c + moves_[move].to : c;
  const std::int64_t cell = std::int64_t{at.y} * grid_->width() + at.x;
  return own_[per_cell ? cell : cell * moves_.count + move];
}

void HeuristicRows::measure_distances(Poller& poller) {
  // Dijkstra from the goal, over 4 or 8 neighbours under the corner rule. Moves can be walked both
  // ways: what closes a corner lies beside it.
  const auto steps = moves_of(moves_.count == 4 ? Neighbours::four : Neighbours::eight);
  const auto index = [&](Cell c) { return static_cast<std::int64_t>(c.y) * grid_->width() + c.x; };
  distances_ = ZeroArray<float>(static_cast<std::int64_t>(grid_->width()) * grid_->height());
  using Item = std::tuple<float, int, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  open.emplace(0.0f, goal_.y, goal_.x);
  constexpr int kWordsACell = 64;  // of work
  while (!open.empty() && !poller.stop_after(kWordsACell)) {
    const auto [length, y, x] = open.top();
    open.pop();
    const Cell c{x, y};
    if (length > distances_[index(c)]) continue;
    for (int k = 0; k < steps.count; ++k) {
      if (!move_exists(*grid_, params_.corners, c, steps[k])) continue;
      const Cell to = c + steps[k].to;
      if (to == goal_) continue;
      const float through = length + static_cast<float>(steps[k].length);
      float& known = distances_[index(to)];
      if (known != 0 && through >= known) continue;
      known = through;
      open.emplace(through, to.y, to.x);
    }
  }
}

}  // namespace lasius
