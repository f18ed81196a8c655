#include "core/vehicle/bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/cost/cost_search.h"
#include "core/vehicle/angle.h"
#include "core/vehicle/end_price.h"
#include "core/vehicle/steering.h"

namespace lasius::vehicle {

Bound::Bound(const Grid& grid, const Vehicle& vehicle, const Prices& prices)
    : vehicle_(vehicle),
      prices_(prices),
      radius_(std::min(inscribed_radius(vehicle), disc::kLargestRadius)),
      grid_(grid) {}

/// Around a clear point no line of sight of the disc is ended so near: where one is, it touches the
/// circle of the disc's radius about something blocked.
double Bound::open_around(const disc::DiscSpace& disc, Point p) const {
  const double radius = disc.radius(), turn = vehicle_.turning_radius;
  const double most = std::min(std::sqrt(radius * radius + turn * turn), disc::kLargestRadius + 1);
  const double clear = disc.clearance(p, most);
  return std::sqrt(std::max(0.0, clear * clear - radius * radius));
}

const disc::DiscSpace* Bound::space(const StopCondition& stop) const {
  if (!disc::has_space(radius_)) return nullptr;
  return space_.get(stop, [&] { return disc::DiscSpace::make(grid_, radius_, stop); });
}

double Bound::around_obstacles(const Pose& start, const Pose& goal, double turned,
                               const StopCondition& stop) const {
  const Point from{start.x, start.y}, to{goal.x, goal.y};
  const disc::DiscSpace* disc = space(stop);
  if (disc == nullptr || !disc->clear(from) || !disc->clear(to)) return 0;
  std::unique_ptr<disc::DiscSearch> search;
  {
    const std::scoped_lock lock(mutex_);
    if (!spare_.empty()) {
      search = std::move(spare_.back());
      spare_.pop_back();
    }
  }
  if (!search) search = std::make_unique<disc::DiscSearch>();
  disc::DiscAnswer answer;
  search->search(*disc, nullptr, from, to, {.target_gap = 0.001}, stop, answer);
  double least = answer.lower_bound;
  if (vehicle_.turning_radius > 0 && !vehicle_.rotate_in_place && std::isfinite(least) &&
      !disc->sees(from, to)) {
    const EndPrice start_price(vehicle_, start.yaw, open_around(*disc, from), 0.5 * least, 0);
    const EndPrice goal_price(vehicle_, goal.yaw + kPi, open_around(*disc, to), 0.5 * least,
                              turned);
    least = std::max(least, search->least(*disc, from, to,
                                          {[&](Point towards) { return start_price(towards); },
                                           [&](Point towards) { return goal_price(towards); },
                                           start_price.most() + goal_price.most()},
                                          0, stop));
  }
  const std::scoped_lock lock(mutex_);
  spare_.push_back(std::move(search));
  return least;
}

// The reference point lies in the disc: its path is one over the cells that the disc's centre may
// be in. Each end is moved inside its cell, straight, which saves no more than that costs.
double Bound::over_weights(Point start, Point goal, bool joined, const StopCondition& stop) const {
  constexpr double kOff = 1e-4;
  if (inscribed_radius(vehicle_) <= 0) return 0;
  const disc::DiscSpace* disc = space(stop);
  if (disc == nullptr && (disc::has_space(radius_) || !joined)) return 0;
  if (disc != nullptr && (!disc->clear(start) || !disc->clear(goal))) return 0;
  if (disc != nullptr && !disc->joined(start, goal)) return kInfinity;
  const cost::Terrain* terrain = terrain_.get(stop, [&] {
    return std::optional(
        cost::Terrain(disc != nullptr ? disc->blocked_cells() : grid_, prices_.weights()));
  });
  if (terrain == nullptr) return 0;
  double moved = 0;
  const auto put = [&](Point p, Cell& cell) {
    cell = {floor_of(p.x), floor_of(p.y)};
    for (const Cell beside :
         {Cell{cell.x - 1, cell.y}, Cell{cell.x, cell.y - 1}, Cell{cell.x - 1, cell.y - 1}}) {
      const bool touched =
          (beside.x == cell.x || p.x == cell.x) && (beside.y == cell.y || p.y == cell.y);
      if (!terrain->free(cell.x, cell.y) && touched) cell = beside;
    }
    const Point at{std::clamp(p.x - cell.x, kOff, 1 - kOff),
                   std::clamp(p.y - cell.y, kOff, 1 - kOff)};
    moved += terrain->weight(cell.x, cell.y) * distance(at, {p.x - cell.x, p.y - cell.y});
    return at;
  };
  Cell from, to;
  const Point from_at = put(start, from), to_at = put(goal, to);
  if (from == to || !terrain->free(from.x, from.y) || !terrain->free(to.x, to.y)) return 0;
  cost::CostSearch search;
  cost::CostAnswer answer;
  search.search(*terrain, {from, to, from_at, to_at}, {.target_gap = 0.01}, stop, answer);
  return answer.lower_bound * (1 - 1e-9) - moved;
}

double Bound::least(const Request& request, bool around) const {
  constexpr std::size_t kMost = 16;  // goals, around the obstacles
  const Pose& start = request.start;
  Steering steering(vehicle_);
  double least = std::numeric_limits<double>::infinity();
  for (const Pose& goal : request.goals) {
    const double dx = goal.x - start.x;
    const double dy = goal.y - start.y;
    double bound = std::sqrt(dx * dx + dy * dy);
    if (request.goal_tolerance == 0 && request.heading_tolerance == 0) {
      bound = std::max(bound, steering.least(start, goal));
    }
    // Within a tolerance it may end on the other side of a wall.
    if (around && request.goals.size() <= kMost && request.goal_tolerance == 0) {
      const Point from{start.x, start.y}, to{goal.x, goal.y};
      bound = std::max(
          bound, prices_.weighted()
                     ? over_weights(from, to, request.goals.size() == 1, request.stop)
                     : around_obstacles(start, goal, request.heading_tolerance, request.stop));
    }
    least = std::min(least, bound - request.goal_tolerance);
  }
  return std::max(0.0, least);
}

std::optional<double> Bound::told(double bound, double reached, bool weighted) noexcept {
  const double allowed = (weighted ? 1e-3 : 1e-6) * (1 + reached);
  return bound <= reached + allowed ? std::optional(std::min(bound, reached)) : std::nullopt;
}

bool Bound::cut_off(const Request& request) const {
  const disc::DiscSpace* disc = space(request.stop);
  const Point start{request.start.x, request.start.y};
  if (disc == nullptr || request.goal_tolerance > 0 || !disc->clear(start)) return false;
  return std::ranges::none_of(request.goals, [&](const Pose& goal) {
    const Point at{goal.x, goal.y};
    return disc->clear(at) && disc->joined(start, at);
  });
}

}  // namespace lasius::vehicle
