#include "core/vehicle/bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/vehicle/steering.h"

namespace lasius::vehicle {

Bound::Bound(const Grid& grid, const Vehicle& vehicle)
    : vehicle_(vehicle),
      radius_(std::min(inscribed_radius(vehicle), disc::kLargestRadius)),
      grid_(grid) {}

const disc::DiscSpace* Bound::space(const StopCondition& stop) const {
  if (!disc::has_space(radius_)) return nullptr;
  return space_.get(stop, [&] { return disc::DiscSpace::make(grid_, radius_, stop); });
}

double Bound::around_obstacles(Point start, Point goal, const StopCondition& stop) const {
  const disc::DiscSpace* disc = space(stop);
  if (disc == nullptr || !disc->clear(start) || !disc->clear(goal)) return 0;
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
  search->search(*disc, nullptr, start, goal, {.target_gap = 0.001}, stop, answer);
  const std::scoped_lock lock(mutex_);
  spare_.push_back(std::move(search));
  return answer.lower_bound;
}

double Bound::length(const Request& request) const {
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
    if (request.goals.size() <= kMost && request.goal_tolerance == 0) {
      bound = std::max(bound, around_obstacles({start.x, start.y}, {goal.x, goal.y}, request.stop));
    }
    least = std::min(least, bound - request.goal_tolerance);
  }
  return std::max(0.0, least);
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
