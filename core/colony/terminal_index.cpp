#include "core/colony/terminal_index.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

#include "core/base/special_values.h"
#include "core/grid/move_rule.h"
#include "core/loop/trail_rules.h"

namespace lasius {

using trail_rules::arrived;

void update_terminal_index(Field& field, const GridTours& tours) {
  double longest = 0;
  for (const Tour& tour : tours.ants) {
    if (arrived(tour)) longest = std::max(longest, tour.length);
  }
  if (longest >= field.untouched()) field.raise_untouched(2 * longest);  // unknown stays worse
  for (const Tour& tour : tours.ants) {
    if (!arrived(tour)) continue;
    Cell c = tours.start;
    for (const int k : tour.moves) c = c + tours.moves[k].to;
    field.set_tau(c, 0, 0);
    double least = field.tau(c, 0);
    for (std::size_t i = tour.moves.size(); i-- > 0;) {
      const kernels::Move& move = tours.moves[tour.moves[i]];
      const double through = least + move.length;
      c = {c.x - move.to.dx, c.y - move.to.dy};
      least = field.tau(c, 0);
      if (through >= least) continue;
      field.set_tau(c, 0, through);
      least = field.tau(c, 0);  // as it is stored
    }
  }
}

void best_known_way(Field& field, const kernels::Moves& moves, Cell start, Cell goal,
                    IndexAnswer reading, std::vector<std::uint8_t>& way) {
  way.clear();
  const double unknown = field.untouched();
  if (field.tau(start, 0) >= unknown) return;
  // K falls at each move, by at least the step: the way ends at the goal. Not so beyond 2^24, where
  // a step is lost in rounding: no way then.
  double before = kInfinity;
  for (Cell c = start; c != goal;) {
    const double here = field.tau(c, 0);
    if (!(here < before)) return way.clear();
    before = here;
    int best = 0;
    double largest = -kInfinity;
    for (int k = 0; k < moves.count; ++k) {
      if (!field.exists(c, k)) continue;
      const double there = field.tau(c + moves[k].to, 0), step = moves[k].length;
      const double gradient =
          reading == IndexAnswer::steepest ? (here - there) / step : -(there + step);
      if (gradient <= largest) continue;
      largest = gradient;
      best = k;
    }
    way.push_back(static_cast<std::uint8_t>(best));
    c = c + moves[best].to;
  }
}

void forget_lost_ways(Field& field, const Grid& grid, Corners corners, const kernels::Moves& moves,
                      Cell goal, const Rectangle& part) {
  const double unknown = field.untouched();
  // By K: what holds a cell up has a smaller one, and is settled before.
  using Item = std::tuple<double, int, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> doubtful;
  const auto doubt = [&](Cell c, double above) {
    if (!grid.contains(c) || c == goal) return;
    const double k = field.tau(c, 0);
    if (k > above && k < unknown) doubtful.emplace(k, c.y, c.x);
  };
  const auto held_up = [&](Cell c, double k) {
    constexpr double kRounding = 1 + 0x1p-20;  // K is stored as a float
    return grid.free(c) && std::any_of(moves.move.begin(), moves.move.begin() + moves.count,
                                       [&](const kernels::Move& move) {
                                         if (!move_exists(grid, corners, c, move)) return false;
                                         const double next = field.tau(c + move.to, 0);
                                         return next < k && next + move.length <= k * kRounding;
                                       });
  };
  constexpr int kReach = kernels::kMaxReach;
  for (int y = part.y - kReach; y < part.y + part.height + kReach; ++y) {
    for (int x = part.x - kReach; x < part.x + part.width + kReach; ++x) doubt({x, y}, 0);
  }
  while (!doubtful.empty()) {
    const auto [k, y, x] = doubtful.top();
    doubtful.pop();
    const Cell c{x, y};
    if (field.tau(c, 0) != k || held_up(c, k)) continue;
    field.forget(c);
    for (int m = 0; m < moves.count; ++m) doubt(c + moves[m].to, k);
  }
}

}  // namespace lasius
