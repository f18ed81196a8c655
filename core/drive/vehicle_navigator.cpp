#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/cost/inflation.h"
#include "core/drive/doubts.h"
#include "core/drive/kept_way.h"
#include "core/drive/vehicle_window.h"
#include "core/grid/changed_parts.h"
#include "core/loop/run_status.h"
#include "core/vehicle/angle.h"
#include "lasius/vehicle/navigator.h"

namespace lasius::vehicle {
namespace {

double apart(double x, double y, const Pose& pose) noexcept {
  const double dx = x - pose.x, dy = y - pose.y;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

class Navigator::Impl {
 public:
  Impl(Grid map, const Vehicle& vehicle, std::vector<Pose> goals, const NavigatorOptions& options)
      : map_(std::move(map)),
        options_(options),
        doubts_(options.doubt_after),
        planner_(*Planner::make(map_, vehicle, {}, costs_now())),
        kept_(vehicle),
        around_(circumscribed_radius(vehicle)) {
    if (options_.inflation) {
      follow_ = options_.inflation->radius;
      constexpr double kOne[] = {1};
      cost::check_sum(kOne, *options_.inflation);
    }
    if (options_.costs) take(*options_.costs);
    require_parameter(options.doubt_after >= 0, "doubt_after", options.doubt_after,
                      "give 0 or more steps");
    set_goals(std::move(goals));
  }

  void observe(std::span<const Cell> cells, bool blocked) {
    if (blocked) doubts_.saw_walls(map_, cells);
    for (const Cell c : cells) set(c, blocked);
  }
  void observe(const Rectangle& part, bool blocked) {
    if (blocked) doubts_.saw_walls(map_, part);
    const Rectangle inside = widened(part, 0, map_);
    for (int y = inside.y; y < inside.y + inside.height; ++y)
      for (int x = inside.x; x < inside.x + inside.width; ++x) set({x, y}, blocked);
  }

  void set_costs(CostField costs) {
    (void)costs.range(map_);  // refuses another size
    take(costs);
    options_.costs = std::move(costs);
    changed_ = tempted_ = true;
  }

  const Way& step(const Pose& robot, const StopCondition& stop) {
    require_pose(robot, "a coordinate of the vehicle");
    const int goal = way_.goal;
    way_ = {};
    if (const auto rest = left_from(robot); !rest.empty()) {
      tempted_ = tempted_ || (!news_.empty() && shortens(robot, planner_.cost(rest)));
      news_.clear();
      if (const int there = reached(robot); there >= 0 && !leads_out()) {
        way_.rejoined = 0;
        tell({{.begin = robot, .length = 0, .gear = 1}}, there);
      } else if (!tempted_ || !shorter(robot, rest, stop)) {
        tell(rest, goal);
      }
      return way_;
    }
    news_.clear();
    tempted_ = false;
    plan(robot, stop);
    if (!way_.segments.empty() || stop.poll() != StopCondition::Cause::none) return way_;
    if (const std::vector<Cell> doubtful = doubts_.wait(map_); !doubtful.empty()) {
      for (const Cell c : doubtful) set(c, false);
      news_.clear();
      plan(robot, stop);
      way_.doubted = static_cast<std::int64_t>(doubtful.size());
    }
    return way_;
  }

  void set_goals(std::vector<Pose> goals) {
    if (goals.empty()) throw invalid_parameter("there is no goal", "give at least one");
    goals_ = std::move(goals);
    kept_.drop();
  }
  std::span<const Pose> goals() const noexcept { return goals_; }
  void forget() noexcept { kept_.drop(); }
  double cost(std::span<const Segment> segments) const { return planner_.cost(segments); }
  const Grid& map() const noexcept { return map_; }

 private:
  static constexpr double kOnWay = 1e-6;  // cells

  const Vehicle& vehicle() const noexcept { return planner_.space().vehicle(); }

  /// Of the map as it is known; null without. Holds until the next call.
  const CostField* costs_now() {
    if (!options_.costs && !options_.inflation) return nullptr;
    costs_ = options_.costs ? options_.costs : CostField(map_.width(), map_.height());
    if (options_.inflation) costs_->add(map_, *options_.inflation);
    return &*costs_;
  }

  /// What follows from costs; walls that will be seen may add their inflation to any of them.
  void take(const CostField& costs) {
    if (options_.inflation) cost::check_sum(costs.weights(), *options_.inflation);
    unit_ = std::ranges::min(costs.weights());
  }

  void set(Cell cell, bool blocked) {
    if (!map_.contains(cell) || map_.blocked(cell) == blocked) return;
    map_.set_blocked(cell, blocked);
    news_.push_back(cell);
    changed_ = true;
  }

  /// What is left of the way that is kept, as far as it still holds, from the vehicle on.
  std::vector<Segment> left_from(const Pose& robot) {
    if (!kept_.kept()) return {};
    const double off = kept_.locate(robot);
    std::vector<Segment> rest = kept_.rest();
    std::vector<Cell> walls = news_;
    std::erase_if(walls, [&](Cell c) { return map_.free(c); });
    if (meets(vehicle(), rest, walls)) rest.clear();
    if (!rest.empty() && off > kOnWay) {
      rest = vehicle().curvature_rate > 0
                 ? std::vector<Segment>()
                 : rejoined(vehicle(), map_, robot, off, rest, way_.rejoined);
      if (!rest.empty()) kept_.keep(rest);
      led_out_ = false;
    }
    if (rest.empty()) kept_.drop();
    return rest;
  }

  /// Whether a way over a cell that has become free might be cheaper than what is left: a price is
  /// never below the length at the least weight, and the footprint comes to the cell. With an
  /// inflation cells that became blocked count, too, and as far as it reaches.
  bool shortens(const Pose& robot, double left) const {
    constexpr double kSlack = 2;
    return std::ranges::any_of(news_, [&](Cell c) {
      if (map_.blocked(c) && follow_ == 0) return false;
      const Point middle = centre(c);
      double on = std::numeric_limits<double>::infinity();
      for (const Pose& goal : goals_) on = std::min(on, apart(middle.x, middle.y, goal));
      return apart(middle.x, middle.y, robot) + on - options_.goal_tolerance <
             left / unit_ + 2 * (around_ + follow_) + kSlack;
    });
  }
  /// The goal that it is at within the tolerances; or -1.
  int reached(const Pose& robot) const {
    const auto at = std::ranges::find_if(goals_, [&](const Pose& goal) {
      return apart(robot.x, robot.y, goal) <= options_.goal_tolerance &&
             std::fabs(half_turned(goal.yaw - robot.yaw)) <= options_.heading_tolerance + 1e-9;
    });
    return at == goals_.end() ? -1 : static_cast<int>(at - goals_.begin());
  }
  /// Plans anew; true where that is cheaper than what is left, which else stays.
  bool shorter(const Pose& robot, std::span<const Segment> rest, const StopCondition& stop) {
    Way before = std::exchange(way_, {});
    KeptWay kept = kept_;
    const bool led_out = led_out_;
    plan(robot, stop);
    tempted_ = stop.poll() != StopCondition::Cause::none;
    if (!way_.segments.empty() && way_.cost < planner_.cost(rest) - kOnWay) return true;
    way_ = std::move(before);
    kept_ = std::move(kept);
    led_out_ = led_out;
    return false;
  }

  Request request(const Pose& from, const StopCondition& stop) const {
    return {.start = from,
            .goals = goals_,
            .goal_tolerance = options_.goal_tolerance,
            .heading_tolerance = options_.heading_tolerance,
            .weight = options_.weight,
            .smooth = options_.smooth,
            .bound = false,
            .max_states = options_.max_states,
            .stop = stop};
  }

  void plan(const Pose& robot, const StopCondition& stop) {
    way_ = {};
    way_.replanned = true;
    kept_.drop();
    if (changed_) {
      if (const auto cause = stop.poll(); cause != StopCondition::Cause::none)
        return tell_stopped(cause);
      std::optional<Planner> planner = planner_.on(map_, stop, costs_now());
      if (!planner) return tell_stopped(stop.poll());
      planner_ = std::move(*planner);
      changed_ = false;
    }
    static_cast<Result&>(way_) = planner_.plan(request(robot, stop));
    if (way_.status == Status::invalid && way_.fault == Fault::start_blocked) lead_out(robot, stop);
    if (way_.segments.empty()) return;
    doubts_.end_wait();
    kept_.keep(way_.segments);
    led_out_ = way_.way_out > 0;
  }

  /// Out of what the vehicle meets where it stands, and on from there.
  void lead_out(const Pose& robot, const StopCondition& stop) {
    for (const Segment& out : ways_out(vehicle(), map_, robot, stop)) {
      if (stop.poll() != StopCondition::Cause::none) break;
      Result on = planner_.plan(request(out.end(), stop));
      if (on.segments.empty()) continue;
      on.segments.insert(on.segments.begin(), out);
      static_cast<Result&>(way_) = std::move(on);
      way_.way_out = 1;
      return measure();
    }
    if (const auto cause = stop.poll(); cause != StopCondition::Cause::none) tell_stopped(cause);
  }
  void tell_stopped(StopCondition::Cause cause) {
    way_ = {};
    way_.replanned = true;
    way_.status = status_after(cause, Status::limit);
    way_.error = "stopped before a path was found";
  }

  void tell(std::vector<Segment> rest, int goal) {
    way_.segments = std::move(rest);
    way_.status = Status::solved;
    way_.goal = goal;
    way_.way_out = leads_out() ? 1 : 0;
    measure();
  }
  bool leads_out() const noexcept { return led_out_ && kept_.in_first(); }
  void measure() {
    way_.length = driven_length(way_.segments);
    way_.cost = planner_.cost(way_.segments);
    way_.over_costs = costs_.has_value();
    way_.cusps = cusps(way_.segments);
    if (vehicle().curvature_rate > 0) way_.corners = corners(way_.segments);
  }

  Grid map_;
  NavigatorOptions options_;
  Doubts doubts_;
  std::optional<CostField> costs_;  ///< as of the planner
  double unit_ = 1;                 ///< no cell's length costs less
  double follow_ = 0;               ///< cells from what is blocked that its inflation reaches
  Planner planner_;                 ///< on the map as it was when last planned on
  bool changed_ = false;            ///< since then
  KeptWay kept_;
  bool led_out_ = false;  ///< by its first segment
  double around_;
  std::vector<Pose> goals_;
  std::vector<Cell> news_;  ///< cells that changed since the last step
  bool tempted_ = false;    ///< a shorter way was not looked for to the end
  Way way_;
};

Navigator::Navigator(Grid map, const Vehicle& vehicle, std::vector<Pose> goals,
                     const NavigatorOptions& options)
    : impl_(std::make_unique<Impl>(std::move(map), vehicle, std::move(goals), options)) {}
Navigator::~Navigator() = default;
Navigator::Navigator(Navigator&&) noexcept = default;
Navigator& Navigator::operator=(Navigator&&) noexcept = default;

void Navigator::observe(std::span<const Cell> cells, bool blocked) {
  impl_->observe(cells, blocked);
}
void Navigator::observe(const Rectangle& part, bool blocked) { impl_->observe(part, blocked); }
void Navigator::set_costs(CostField costs) { impl_->set_costs(std::move(costs)); }
const Way& Navigator::step(const Pose& robot, const StopCondition& stop) {
  return impl_->step(robot, stop);
}
double Navigator::cost(std::span<const Segment> segments) const { return impl_->cost(segments); }
std::span<const Pose> Navigator::goals() const noexcept { return impl_->goals(); }
void Navigator::set_goals(std::vector<Pose> goals) { impl_->set_goals(std::move(goals)); }
void Navigator::forget() { impl_->forget(); }
const Grid& Navigator::map() const noexcept { return impl_->map(); }

}  // namespace lasius::vehicle
