#include "lasius/vehicle/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/vehicle/angle.h"
#include "core/vehicle/blend.h"
#include "core/vehicle/bound.h"
#include "core/vehicle/search.h"
#include "core/vehicle/smooth.h"

namespace lasius::vehicle {

class Planner::Impl {
 public:
  Impl(const Grid& grid, Space the_space, const Vehicle& vehicle, const CostField* costs,
       std::shared_ptr<const Lattice> of_vehicle, Poller& poller)
      : asked(vehicle),
        space(std::move(the_space)),
        lattice(of_vehicle
                    ? std::move(of_vehicle)
                    : std::make_shared<const Lattice>(space.vehicle(), space.impl().outline())),
        free(space.impl(), *lattice, poller),
        over_costs(costs != nullptr),
        prices(grid, space.vehicle(), costs),
        bound(grid, asked, prices) {
    if (prices.weighted()) edges.emplace(prices, space.vehicle(), *lattice);
  }

  /// Memory that no other search holds.
  std::unique_ptr<SearchMemory> take() const {
    const std::scoped_lock lock(mutex);
    if (spare.empty()) return std::make_unique<SearchMemory>();
    std::unique_ptr<SearchMemory> taken = std::move(spare.back());
    spare.pop_back();
    return taken;
  }
  void give_back(std::unique_ptr<SearchMemory> memory) const {
    const std::scoped_lock lock(mutex);
    spare.push_back(std::move(memory));
  }

  /// The rounds of a search, each for longer ways than the one before, as long as none is found.
  Found look(const Request& request, const std::vector<Goal>& goals, Result& counts,
             Poller& poller) const;
  /// The path that was found, shortened, with all that is told of it; false where it does not hold.
  bool take_path(const Request& request, const Found& found, Result& result, Poller& poller) const;
  /// Why there is no path.
  void tell_none(const Request& request, bool full, Result& result) const;

  /// What a length of the bound comes to.
  double unit() const { return over_costs ? prices.unit() : 1; }

  Vehicle asked;  ///< the space's has wider turns where its curvature may change so fast alone
  Space space;
  std::shared_ptr<const Lattice> lattice;  ///< of the vehicle alone
  FreeHeadings free;
  bool over_costs;
  Prices prices;
  std::optional<EdgePrices> edges;
  Bound bound;
  MadeOnce<EdgePlanes> planes;
  mutable std::mutex mutex;
  mutable std::vector<std::unique_ptr<SearchMemory>> spare;
};

namespace {

void check(const Request& request) {
  const auto check_pose = [](const Pose& pose, const char* name) {
    for (const double value : {pose.x, pose.y, pose.yaw}) {
      require_parameter(std::fabs(value) <= 1e5, name, value,
                        "give finite numbers of at most 100000");
    }
  };
  check_pose(request.start, "a coordinate of the start");
  if (request.goals.empty()) throw invalid_parameter("there is no goal", "give at least one");
  for (const Pose& goal : request.goals) check_pose(goal, "a coordinate of a goal");
  require_parameter(request.goal_tolerance >= 0 && request.goal_tolerance <= 1000, "goal_tolerance",
                    request.goal_tolerance, "give 0 to 1000 cells");
  require_parameter(request.heading_tolerance >= 0 && request.heading_tolerance <= 100,
                    "heading_tolerance", request.heading_tolerance, "give 0 to 100 radians");
  require_parameter(request.weight >= 1 && request.weight <= 100, "weight", request.weight,
                    "give 1 to 100");
  require_parameter(request.max_states >= 1 && request.max_states <= 100'000'000, "max_states",
                    request.max_states, "give 1 to 100000000");
}

/// The goal that the start is at already, within the tolerances; or -1.
int reached(const Request& request) {
  const Pose& at = request.start;
  for (int i = 0; i < static_cast<int>(request.goals.size()); ++i) {
    const Pose& goal = request.goals[i];
    const double dx = goal.x - at.x, dy = goal.y - at.y;
    if (std::sqrt(dx * dx + dy * dy) <= request.goal_tolerance &&
        std::fabs(half_turned(goal.yaw - at.yaw)) <= request.heading_tolerance + 1e-9)
      return i;
  }
  return -1;
}

/// Of goals as they are given, those that are free; with a tolerance of the heading other yaws,
/// too.
std::vector<Goal> goals_of(const Space& space, const Lattice& lattice, const Request& request) {
  std::vector<Goal> goals;
  for (int i = 0; i < static_cast<int>(request.goals.size()); ++i) {
    const Pose& goal = request.goals[i];
    if (space.free(goal)) goals.push_back({goal, i});
    for (int h = 0; h < Lattice::kHeadings && request.heading_tolerance > 0; ++h) {
      const double off = half_turned(lattice.yaw(h) - goal.yaw);
      if (std::fabs(off) > request.heading_tolerance || std::fabs(off) < 1e-9) continue;
      const Pose turned{goal.x, goal.y, goal.yaw + off};
      if (space.free(turned)) goals.push_back({turned, i});
    }
  }
  return goals;
}

/// Joins motions that go on as one.
std::vector<Segment> joined(const std::vector<Segment>& segments) {
  std::vector<Segment> told;
  for (const Segment& s : segments) {
    if (!told.empty()) {
      Segment& last = told.back();
      const bool on = s.gear == 0 ? (last.angle > 0) == (s.angle > 0) : last.angle == s.angle;
      if (last.gear == s.gear && last.curvature == s.curvature && on && last.curvature_rate == 0 &&
          s.curvature_rate == 0) {
        last.length += s.length;
        if (s.gear == 0) last.angle += s.angle;
        continue;
      }
    }
    told.push_back(s);
  }
  return told;
}

/// Ends, joints, what the vehicle can drive, contacts: compared before a path is answered.
bool holds(const Space& space, const Vehicle& vehicle, const Request& request, int goal,
           std::span<const Segment> path) {
  constexpr double kOff = 1e-7;
  const auto apart = [](const Pose& a, const Pose& b) {
    const double dx = a.x - b.x, dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
  };
  const auto turned = [](const Pose& a, const Pose& b) {
    return std::fabs(half_turned(a.yaw - b.yaw));
  };
  Pose at = request.start;
  for (const Segment& s : path) {
    const bool drives = s.gear > 0 || (s.gear < 0 ? vehicle.reverse : vehicle.rotate_in_place);
    const double bent = s.sharpest() * vehicle.turning_radius;
    if (std::fabs(s.curvature_rate) > vehicle.curvature_rate * (1 + 1e-12)) return false;
    if (!drives || (s.gear != 0 && s.angle != 0 && !vehicle.sideways) || !(bent <= 1 + 1e-12) ||
        (vehicle.turning_radius == 0 && s.curvature != 0) || !(apart(at, s.begin) <= kOff) ||
        !(turned(at, s.begin) <= kOff))
      return false;
    at = s.end();
  }
  const Pose& wanted = request.goals[goal];
  return apart(at, wanted) <= request.goal_tolerance + kOff &&
         turned(at, wanted) <= request.heading_tolerance + kOff && !space.first_contact(path);
}

void refuse(Result& result, const Space& space, const Pose& pose, bool start) {
  result.status = Status::invalid;
  result.touched = space.contact(pose);
  const bool outside = !(pose.x >= 0 && pose.y >= 0 && pose.x <= space.impl().width() &&
                         pose.y <= space.impl().height());
  result.fault = start ? (outside ? Fault::start_outside : Fault::start_blocked)
                       : (outside ? Fault::goal_outside : Fault::goal_blocked);
  const std::string end = start ? "start" : "goal";
  if (outside) {
    result.error = "the " + end + " is outside the map";
    return;
  }
  const Cell cell = *result.touched;
  result.error = "at the " + end + " the vehicle touches cell (" + std::to_string(cell.x) + ", " +
                 std::to_string(cell.y) + ")";
}

}  // namespace

std::optional<double> Result::gap() const {
  if (segments.empty() && goal < 0) return std::nullopt;
  if (!lower_bound) return std::nullopt;
  const double reached = over_costs ? cost : length;
  if (reached <= *lower_bound) return 0.0;
  return *lower_bound > 0 ? std::optional((reached - *lower_bound) / *lower_bound) : std::nullopt;
}

Planner::Planner(const Grid& grid, const Vehicle& vehicle) : Planner(*make(grid, vehicle, {})) {}
Planner::Planner(const Grid& grid, const Vehicle& vehicle, const CostField& costs)
    : Planner(*make(grid, vehicle, {}, &costs)) {}

std::optional<Planner> Planner::make(const Grid& grid, const Vehicle& vehicle,
                                     const StopCondition& stop, const CostField* costs) {
  Planner planner;
  return planner.prepare(grid, vehicle, costs, stop) ? std::optional(std::move(planner))
                                                     : std::nullopt;
}

std::optional<Planner> Planner::on(const Grid& grid, const StopCondition& stop,
                                   const CostField* costs) const {
  Planner planner(*this);
  return planner.prepare(grid, impl_->asked, costs, stop) ? std::optional(std::move(planner))
                                                          : std::nullopt;
}

bool Planner::prepare(const Grid& grid, const Vehicle& vehicle, const CostField* costs,
                      const StopCondition& stop) {
  validate(vehicle);
  std::optional<Space> space = Space::make(grid, with_room(vehicle), stop);
  if (!space) return false;
  Poller poller(stop);
  impl_ = std::make_shared<const Impl>(grid, std::move(*space), vehicle, costs,
                                       impl_ ? impl_->lattice : nullptr, poller);
  return !poller.stopped();
}

Planner::Planner(const Planner&) noexcept = default;
Planner& Planner::operator=(const Planner&) noexcept = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;
Planner::~Planner() = default;

const Space& Planner::space() const noexcept { return impl_->space; }

bool Planner::over_costs() const noexcept { return impl_->over_costs; }
double Planner::cost(std::span<const Segment> segments) const {
  return impl_->prices.unit() * impl_->prices.of(segments);
}

bool Planner::cut_off(const Request& request) const {
  check(request);
  return impl_->bound.cut_off(request);
}

double Planner::lower_bound(const Request& request, bool around) const {
  check(request);
  if (around && impl_->bound.cut_off(request)) return std::numeric_limits<double>::infinity();
  return impl_->unit() * impl_->bound.least(request, around);
}

Found Planner::Impl::look(const Request& request, const std::vector<Goal>& goals, Result& counts,
                          Poller& poller) const {
  const Prepared prepared{space.impl(), *lattice, free, planes, prices, edges ? &*edges : nullptr};
  SearchOptions options{.weight = request.weight,
                        .lattice_tolerance = request.goal_tolerance,
                        .heading_tolerance = request.heading_tolerance,
                        .wanted = request.goals,
                        .max_states = request.max_states,
                        .stop = request.stop};
  std::unique_ptr<SearchMemory> memory = take();
  const auto once = [&] {
    return search(prepared, request.start, goals, options, *memory, counts, poller);
  };
  Found found = once();
  const auto lost = [&] { return found.goal < 0 && !poller.stopped() && !found.full; };
  options.wide = true;
  if (lost()) found = once();
  // What only drives forwards hardly gets out of a pocket, and omni has no need to.
  options.creeps = !asked.sideways && (asked.reverse || asked.rotate_in_place);
  if (options.creeps && lost()) found = once();
  give_back(std::move(memory));
  return found;
}

bool Planner::Impl::take_path(const Request& request, const Found& found, Result& result,
                              Poller& poller) const {
  std::vector<Segment> path = joined(found.segments);
  const auto keep = [&](std::vector<Segment>&& segments) {
    if (!holds(space, asked, request, found.goal, segments)) return;
    result.goal = found.goal;
    result.segments = std::move(segments);
  };
  // The masks' proof is of motions told another way: all is certified once more.
  keep(std::move(path));
  if (result.goal < 0) return false;
  if (request.smooth && !poller.stopped()) {
    std::vector<Segment> shorter =
        joined(smoothed(space.impl(), prices, result.segments, result.checked, poller));
    if (prices.of(shorter) <= prices.of(result.segments)) keep(std::move(shorter));
  }
  if (asked.curvature_rate > 0 && !poller.stopped())
    keep(blended(space.impl(), asked, result.segments, result.checked, poller));
  result.length = driven_length(result.segments);
  result.cost = prices.unit() * prices.of(result.segments);
  result.cusps = cusps(result.segments);
  if (asked.curvature_rate > 0) result.corners = corners(result.segments);
  if (request.bound)
    result.lower_bound = Bound::told(unit() * bound.least(request),
                                     over_costs ? result.cost : result.length, prices.weighted());
  return true;
}

void Planner::Impl::tell_none(const Request& request, bool full, Result& result) const {
  if (bound.cut_off(request)) {
    result.status = Status::unreachable;
    result.fault = Fault::disconnected;
    result.error = "no way is wide enough for the disc inside the footprint";
    return;
  }
  result.error =
      full ? "none was found before max_states states were entered"
           : "none in the lattice that was searched; on a map of finer cells one may be found";
}

Result Planner::plan(const Request& asked) const {
  check(asked);
  const Space& space = impl_->space;
  Request request = asked;  // of the same poses, with all of their digits for what is turned
  request.start.yaw = half_turned(request.start.yaw);
  for (Pose& goal : request.goals) goal.yaw = half_turned(goal.yaw);
  Result result;
  result.over_costs = impl_->over_costs;
  if (!space.free(request.start)) {
    refuse(result, space, request.start, true);
    return result;
  }
  if (const int there = reached(request); there >= 0) {
    result.status = Status::solved;
    result.goal = there;
    result.segments = {{.begin = request.start, .length = 0, .gear = 1}};
    if (request.bound) result.lower_bound = 0;
    return result;
  }
  const std::vector<Goal> goals = goals_of(space, *impl_->lattice, request);
  if (goals.empty() && request.goal_tolerance <= 0) {
    refuse(result, space, request.goals.front(), false);
    return result;
  }
  Poller poller(request.stop, Poller::kSteps * 16);
  const Found found = impl_->look(request, goals, result, poller);
  const bool has_path = found.goal >= 0 && impl_->take_path(request, found, result, poller);
  // What shortens the path, and its bound, may be cut short, too.
  StopCondition::Cause cause = poller.cause();
  if (cause == StopCondition::Cause::none && has_path) cause = request.stop.poll();
  if (cause != StopCondition::Cause::none)
    result.status = cause == StopCondition::Cause::token ? Status::interrupted : Status::limit;
  else if (has_path)
    result.status = Status::solved;
  if (!has_path && poller.stopped())
    result.error = "stopped before a path was found";
  else if (!has_path)
    impl_->tell_none(request, found.full, result);
  return result;
}

}  // namespace lasius::vehicle
