// Ways over cells, out of where a robot may not be, and on from where it is.

#include <algorithm>
#include <utility>

#include "core/drive/navigator_impl.h"
#include "core/drive/rejoin.h"
#include "core/drive/retreat.h"
#include "core/grid/cell_distance.h"
#include "core/grid/nearest_free.h"
#include "core/grid/walk_cells.h"
#include "core/loop/run_status.h"
#include "lasius/path/path.h"

namespace lasius {

void Navigator::Impl::walk_over_cells(const StopCondition& stop) {
  const Cell from = cell_at(way.path.front());
  Cell to = cell_at(way.path.back());
  const Corners rule = rule_of_walks(corners);
  std::vector<Cell> piece(1, from);
  PathWalker ahead = walker;
  do {
    ahead.next(map.passable(), rule, piece.back(), piece);
  } while (piece.size() > 1 && piece.back() != to);
  if (piece.back() == to) return;
  if (connected(from, to, corners, stop) == false) {
    const auto near = nearest_walked_to(from, stop);
    if (!near) return walker.begin({}, true);
    way.goal_reached = to = *near;
    way.lower_bound.reset();
  }
  const auto cells = shortest_walk_cells(map.passable(), from, to, Neighbours::eight, rule, stop);
  if (cells.empty()) return end_run(way, stop.poll(), Status::limit);
  way.path.clear();
  for (const Cell c : cells) way.path.push_back(centre(c));
  way.curve.clear();
  way.length = path_length(way.path);
  way.optimal = false;
  walker.begin(way.path, true);
}

std::optional<Cell> Navigator::Impl::nearest_walked_to(Cell from, const StopCondition& stop) {
  if (options.goal_tolerance == 0) return std::nullopt;
  Poller poller(stop);
  const auto near = nearest_free(map.passable(), Spot{goal}, poller,
                                 [&](Cell c) { return connected(from, c, corners, stop) == true; });
  return near && distance(*near, goal) <= options.goal_tolerance ? near : std::nullopt;
}

void Navigator::Impl::leave(Cell robot, const StopCondition& stop) {
  const Grid& passable = map.passable();
  const auto leads_on = [&](Cell c) {
    return passable.free(c) && connected(c, goal, corners, stop) == true;
  };
  const Corners rule = rule_of_walks(corners);
  auto out = find_way_out(map.map(), rule, robot, leads_on);
  if (out.empty() && options.goal_tolerance > 0)
    out = find_way_out(map.map(), rule, robot, [&](Cell c) { return passable.free(c); });
  if (out.empty()) return;
  Result rest = ask(out.back(), stop);
  if (rest.path.empty()) {
    holds = rest.status != Status::limit && rest.status != Status::interrupted;
    return;
  }
  leave_curve(rest);
  rest.length += length_of(out);
  rest.lower_bound.reset();
  rest.optimal = false;
  take(std::move(rest), stop);
  way.way_out = centre(out.back());
  for (std::size_t i = out.size() - 1; i > 0; --i)
    way.path.insert(way.path.begin(), centre(out[i - 1]));
  way.walk = std::move(out);
}

bool Navigator::Impl::go_on(std::size_t moves) {
  if (moves == 0 || costs) return moves == 0;
  auto& path = way.path;
  if (way.way_out) {
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(moves));
    if (centre(way.walk[moves]) == way.way_out) way.way_out.reset();
  } else if (robot_disc) {
    if (!rejoin(*space(), centre(way.walk[moves]), path)) return false;
    way.curve.clear();
  } else {
    const std::size_t left = walker.vertices_after(way.walk[moves]);
    std::size_t last = path.size() - std::min(left + 1, path.size() - 1);
    if (taut) last = std::min(last + 3, path.size() - 1);
    std::vector<kernels::HalfPoint> front;
    for (std::size_t i = moves; i > 0; --i) front.push_back(halves_of(centre(way.walk[i])));
    for (std::size_t i = 0; i <= last; ++i) front.push_back(halves_of(path[i]));
    string.run(map.passable(), front, corners);
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    path.insert(path.begin(), string.path().begin(), string.path().end());
  }
  way.length = path_length(path);
  way.lower_bound.reset();
  way.optimal = false;
  way.walk.erase(way.walk.begin(), way.walk.begin() + static_cast<std::ptrdiff_t>(moves));
  return true;
}

}  // namespace lasius
