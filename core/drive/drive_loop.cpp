#include "core/drive/drive_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/grid/cell_distance.h"
#include "core/loop/run_status.h"

namespace lasius {

DriveLoop::DriveLoop(const Grid& map, const Grid& truth, Cell start, Pilot& pilot,
                     const Changes& changes, const DriveOptions& options, bool may_circle)
    : map_(map),
      options_(options),
      world_(truth, changes, pilot.radius()),
      pilot_(pilot),
      robot_(start),
      may_circle_(may_circle) {}

DriveResult DriveLoop::run() {
  pilot_.begin_drive();
  result_.track = {robot_};
  while (!ended_) tick();
  result_.ticks = tick_;
  result_.deferred_changes = world_.deferrals();
  return std::move(result_);
}

void DriveLoop::tick() {
  world_.advance(tick_, [this](const Rectangle& part) { return holds(part); });
  replanned_ = false;
  if (tick_ == 0 && blocked_at_start()) return;
  look();
  const Found found = at_goal() ? Found::way : find_way();
  arrived_ = at_goal() || (found == Found::way && at_end_of_way());
  result_.planning_ms += planning_.count();
  planning_ = {};
  if (ended_) return;
  const bool stopped = show(found);
  news_.clear();  // what is felt in the move is news of the next tick
  if (arrived_) {
    if (pilot_.goal_tolerance() > 0) result_.goal_reached = robot_;
    return end(Status::solved);
  }
  if (tick_ == options_.max_ticks) {
    result_.limit = Limit::ticks;
    return end(Status::limit);
  }
  if (stopped) return end(Status::interrupted);
  if (const auto cause = options_.stop.poll(); cause != StopCondition::Cause::none) {
    end_run(result_, cause, Status::limit);
    return end(result_.status);
  }
  headway_.count(robot_, world_.still_changed_at() == tick_, found == Found::not_yet);
  if ((world_.stirs() || may_circle_) && !world_.to_change() && headway_.none())
    return end_trapped(world_.stirs() ? "moving obstacles close every way, for good or in turn"
                                      : "no way leads on for long");
  move(found);
  if (!ended_) ++tick_;
}

void DriveLoop::end(Status status, std::string error) {
  ended_ = true;
  result_.status = status;
  result_.error = std::move(error);
}

void DriveLoop::look() {
  const Body body{[this](Cell cell) { return covers(cell); }, reach()};
  sense(world_.now(), pilot_.map(), robot_, options_.sense, body, seen_);
  learn(seen_.blocked, true);
  learn(seen_.free, false);
}

void DriveLoop::learn(const std::vector<Cell>& cells, bool blocked) {
  if (cells.empty()) return;
  result_.seen += static_cast<std::int64_t>(cells.size());
  news_.insert(news_.end(), cells.begin(), cells.end());
  tell(cells, blocked);
}

void DriveLoop::tell(const std::vector<Cell>& cells, bool blocked) {
  const auto begin = options_.stop.now();
  pilot_.observe(cells, blocked);
  planning_ += options_.stop.now() - begin;
}

void DriveLoop::ask() {
  StopCondition stop = options_.stop;
  if (std::isfinite(options_.seconds_per_tick)) {
    const std::chrono::duration<double> left(options_.seconds_per_tick - planning_.count() / 1000);
    stop.deadline = std::min(stop.deadline, deadline_in(left, stop.now()));
  }
  const auto begin = options_.stop.now();
  way_ = &pilot_.step(robot_, stop);
  planning_ += options_.stop.now() - begin;
  if (!way_->replanned) return;
  if (replanned_) result_.replans.pop_back();  // of the same tick
  replanned_ = true;
  result_.replans.push_back({tick_, planning_.count(), way_->length, way_->cost});
}

DriveLoop::Found DriveLoop::find_way() {
  ask();
  const bool no_way = !goes() && proven();
  const bool short_of = way_->goal_reached && *way_->goal_reached != pilot_.goal();
  if ((no_way || short_of) && doubt()) {
    look();
    ask();
  }
  if (goes()) {
    waited_ = attempts_ = 0;
    settle();
    return Found::way;
  }
  if (!proven()) return Found::not_yet;
  if (hopeless()) give_up();
  return Found::none;
}

/// Nothing that is learned, or that is to come, can make a way. To ask what is there spares the
/// robot to look everywhere again; it learns nothing else from it.
bool DriveLoop::hopeless() { return !world_.to_change() && !joined(World::Without::all_obstacles); }

/// Forgets walls that may not be there: of those that were not in sight since the last change the
/// learned ones; where that does not help though there is a way, or time and again did not, those
/// of the map too. False if there is nothing to doubt.
bool DriveLoop::doubt() {
  if (hopeless()) return false;
  const bool again = world_.changed_at() < doubted_at_ || ++doubts_ % kDoubts == 0;
  bool any = false;
  if (!again) {
    doubted_at_ = tick_ + 1;
    any = forget_walls(&map_);
    if (any && pilot_.connected(robot_, pilot_.goal())) return true;
  }
  const bool wait_first = world_.to_change() || world_.stirs();
  if ((wait_first && waited_ < kPatience) || !joined(World::Without::nothing)) return any;
  return forget_walls(nullptr) || any;
}

/// Walls that were in sight since the last change of the world. Looks back along the track, not
/// from each of its cells: a wall that is forgotten is only seen again. Nothing when stopped.
std::optional<Grid> DriveLoop::certain_walls() const {
  Grid certain(map_.width(), map_.height());
  Cell from = robot_;
  const double apart = std::max(1.0, options_.sense / 8);
  for (std::int64_t tick = tick_; tick >= world_.changed_at(); --tick) {
    const Cell cell = result_.track[static_cast<std::size_t>(tick)];
    if (tick < tick_ && distance(from, cell) < apart) continue;
    from = cell;
    if (options_.stop.poll() != StopCondition::Cause::none) return std::nullopt;
    mark_walls_in_sight(world_.now(), from, options_.sense, certain);
  }
  return certain;
}

/// Takes walls that are not certain for free, those of `kept` excepted. False if there are none.
bool DriveLoop::forget_walls(const Grid* kept) {
  const auto certain = certain_walls();
  if (!certain) return false;
  const std::vector<Cell> doubtful = walls_without(pilot_.map(), *certain, kept);
  tell(doubtful, false);
  return !doubtful.empty();
}

void DriveLoop::move(Found found) {
  if (found == Found::way) return follow();
  if (found == Found::not_yet) return stand();
  ++waited_;
  const bool aside = waited_ % kPatience == 0;
  if (aside && !world_.to_change() && trapped())
    return end_trapped("moving obstacles stand in the way for good");
  if (aside) set_out();
  go_aside();
}

void DriveLoop::arrive(Cell cell, bool moved, double length, double cost) {
  result_.waits += moved ? 0 : 1;
  result_.length += length;
  result_.cost += cost;
  robot_ = cell;
  result_.track.push_back(cell);
}

void DriveLoop::end_trapped(const char* why) {
  result_.fault = Fault::trapped;
  end(Status::no_path, std::string("trapped: ") + why);
}

/// Obstacles that wait for the robot, or never move, close all ways, wherever it went aside; or
/// those that move have left none open for long.
bool DriveLoop::trapped() {
  if (waited_ >= Headway::kLongWait) return true;
  return !joined(World::Without::those_that_move) && ++attempts_ > kAttempts;
}

/// True where the observer ends the drive.
bool DriveLoop::show(Found found) {
  if (!options_.observer) return false;
  DriveTick view;
  view.tick = tick_;
  view.robot = robot_;
  view.world = &world_.now();
  view.still = &world_.still();
  view.robot_knows = &pilot_;
  view.arrived = arrived_;
  view.way = found == Found::way && !arrived_ ? way_ : nullptr;
  view.obstacles = world_.obstacles();
  view.news = news_;
  view.replanned = replanned_;
  return options_.observer(view) == Go::stop;
}

}  // namespace lasius
