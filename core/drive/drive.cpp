#include "lasius/drive.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/drive/changes_check.h"
#include "core/drive/headway.h"
#include "core/drive/path_walker.h"
#include "core/drive/retreat.h"
#include "core/drive/sensor.h"
#include "core/drive/world.h"
#include "core/grid/cell_distance.h"
#include "core/grid/components.h"
#include "core/grid/move_rule.h"
#include "core/loop/run_status.h"
#include "core/plan/answer.h"
#include "kernels/base/random_stream.h"

namespace lasius {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

/// A robot under way. See drive() for its rules.
class Drive {
 public:
  /// `map` is what the pilot knows now.
  Drive(const Grid& map, const Grid& truth, Cell start, Pilot& pilot, const Changes& changes,
        const DriveOptions& options, const StopCondition& stop, const DriveObserver& observer)
      : map_(map),
        options_(options),
        stop_(stop),
        observer_(observer),
        corners_(rule_of_walks(pilot.corners())),
        world_(truth, changes, pilot.radius()),
        pilot_(pilot),
        robot_(start),
        before_(start) {}

  DriveResult run() {
    pilot_.begin_drive();
    result_.track = {robot_};
    while (!ended_) tick();
    result_.ticks = tick_;
    result_.deferred_changes = world_.deferrals();
    return std::move(result_);
  }

 private:
  enum class Found { way, none, not_yet };

  void tick() {
    world_.advance(tick_, {before_, robot_});
    replanned_ = false;
    if (tick_ == 0 && blocked_at_start()) return;
    look();
    const Found found = robot_ == pilot_.goal() ? Found::way : find_way();
    arrived_ = robot_ == pilot_.goal() || (found == Found::way && way_->goal_reached == robot_);
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
    if (const auto cause = stop_.poll(); cause != StopCondition::Cause::none) {
      end_run(result_, cause, Status::limit);
      return end(result_.status);
    }
    headway_.count(robot_, world_.still_changed_at() == tick_, found == Found::not_yet);
    if (world_.stirs() && !world_.to_change() && headway_.none())
      return end_trapped("moving obstacles close every way, for good or in turn");
    const Cell to = next_cell(found);
    if (ended_) return;
    go(to);
    ++tick_;
  }

  void end(Status status, std::string error = {}) {
    ended_ = true;
    result_.status = status;
    result_.error = std::move(error);
  }

  /// A start or goal that is blocked or outside ends the drive before it begins.
  bool blocked_at_start() {
    const Cell goal = pilot_.goal();
    const bool bad_start = world_.passable().blocked(robot_);
    if (!bad_start) look();
    if (!bad_start && (pilot_.passable().free(goal) || near_goal())) return false;
    const Cell cell = bad_start ? robot_ : goal;
    auto [fault, text] = fault_of_end(world_.now(), bad_start, cell);
    end(Status::invalid, std::move(text));
    result_.fault = fault;
    const Grid grid =
        bad_start ? world_.passable() : walls_of_both(world_.passable(), pilot_.passable());
    const Cell other = bad_start ? goal : robot_;
    std::optional<Components> components;
    std::function<bool(Cell)> joined;
    if (grid.free(other)) {
      components.emplace(grid, connectivity_of(corners_));
      joined = [&](Cell c) { return components->connected(grid, other, c); };
    }
    find_nearest(result_, grid, cell, stop_.token, joined);
    return true;
  }
  /// A way leads near enough to the goal, as far as is known.
  bool near_goal() {
    if (pilot_.goal_tolerance() > 0) ask();
    return way_ != nullptr && !way_->path.empty();
  }

  void look() {
    sense(world_.now(), pilot_.map(), robot_, options_.sense, world_.growth(), seen_);
    learn(seen_.blocked, true);
    learn(seen_.free, false);
  }
  void learn(const std::vector<Cell>& cells, bool blocked) {
    if (cells.empty()) return;
    result_.seen += static_cast<std::int64_t>(cells.size());
    news_.insert(news_.end(), cells.begin(), cells.end());
    tell(cells, blocked);
  }
  void tell(const std::vector<Cell>& cells, bool blocked) {
    const auto begin = stop_.now();
    pilot_.observe(cells, blocked);
    planning_ += stop_.now() - begin;
  }

  /// One question to the pilot, within the tick's time.
  void ask() {
    StopCondition stop = stop_;
    if (std::isfinite(options_.seconds_per_tick)) {
      const std::chrono::duration<double> left(options_.seconds_per_tick -
                                               planning_.count() / 1000);
      stop.deadline = std::min(stop.deadline, deadline_in(left, stop.now()));
    }
    const auto begin = stop_.now();
    way_ = &pilot_.step(robot_, stop);
    planning_ += stop_.now() - begin;
    if (!way_->replanned) return;
    if (replanned_) result_.replans.pop_back();  // of the same tick
    replanned_ = true;
    result_.replans.push_back({tick_, planning_.count(), way_->length, way_->cost});
  }

  Found find_way() {
    ask();
    const bool no_way = !goes() && proven();
    const bool short_of = way_->goal_reached && *way_->goal_reached != pilot_.goal();
    if ((no_way || short_of) && doubt()) {
      look();
      ask();
    }
    if (goes()) {
      waited_ = attempts_ = 0;
      retreat_.clear();
      return Found::way;
    }
    if (!proven()) return Found::not_yet;
    if (hopeless()) {
      end(Status::unreachable, "as far as is known, no way leads from " + cell_name(robot_) +
                                   " to the goal " + cell_name(pilot_.goal()));
      result_.fault = way_->fault;
    }
    return Found::none;
  }
  /// There is a way. Of a disc's path there may be no walk: then there is none.
  bool goes() const noexcept {
    return !way_->path.empty() && (pilot_.radius() == 0 || way_->walk.size() > 1 ||
                                   robot_ == way_->goal_reached.value_or(pilot_.goal()));
  }
  /// That no way leads to the goal, on what is known.
  bool proven() const noexcept {
    return way_->status == Status::unreachable || way_->status == Status::invalid ||
           (!way_->path.empty() && !goes());
  }

  /// Nothing that is learned, or that is to come, can make a way. To ask what is there spares the
  /// robot to look everywhere again; it learns nothing else from it.
  bool hopeless() { return !world_.to_change() && !joined(World::Without::all_obstacles); }
  /// Looks at the whole map; without obstacles only where that has changed, or the robot moved.
  bool joined(World::Without without) {
    if (without != World::Without::all_obstacles) {
      return world_.joined(robot_, pilot_.goal(), corners_, without);
    }
    if (joined_at_ != world_.still_changed_at() || joined_from_ != robot_) {
      joined_at_ = world_.still_changed_at();
      joined_from_ = robot_;
      joined_ = world_.joined(robot_, pilot_.goal(), corners_, without);
    }
    return joined_;
  }

  /// Forgets walls that may not be there: of those that were not in sight since the last change the
  /// learned ones; where that does not help though there is a way, or time and again did not, those
  /// of the map too. False if there is nothing to doubt.
  bool doubt() {
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
  std::optional<Grid> certain_walls() const {
    Grid certain(map_.width(), map_.height());
    Cell from = robot_;
    const double apart = std::max(1.0, options_.sense / 8);
    for (std::int64_t tick = tick_; tick >= world_.changed_at(); --tick) {
      const Cell cell = result_.track[static_cast<std::size_t>(tick)];
      if (tick < tick_ && distance(from, cell) < apart) continue;
      from = cell;
      if (stop_.poll() != StopCondition::Cause::none) return std::nullopt;
      mark_walls_in_sight(world_.now(), from, options_.sense, certain);
    }
    return certain;
  }
  /// Walls that are not certain are taken for free, those that `kept` has excepted. False if there
  /// are none.
  bool forget_walls(const Grid* kept) {
    const auto certain = certain_walls();
    if (!certain) return false;
    const std::vector<Cell> doubtful = walls_without(pilot_.map(), *certain, kept);
    tell(doubtful, false);
    return !doubtful.empty();
  }

  /// The cell to be in at the next tick; the robot's own for a wait.
  Cell next_cell(Found found) {
    if (found == Found::way && way_->walk.size() < 2) return robot_;
    if (found == Found::way) {
      const Cell next = way_->walk[1];
      if (std::abs(std::int64_t{next.x} - robot_.x) > 1 ||
          std::abs(std::int64_t{next.y} - robot_.y) > 1)
        throw invalid_parameter(
            "the pilot's walk does not go on in a neighbour of the robot's cell",
            "give each cell of the way in Way::walk");
      return next;
    }
    if (found == Found::not_yet) return robot_;
    ++waited_;
    const bool aside = waited_ % kPatience == 0;
    if (aside && !world_.to_change() && trapped()) {
      end_trapped("moving obstacles stand in the way for good");
      return robot_;
    }
    if (aside) {
      const auto tick = static_cast<std::uint64_t>(tick_);
      const auto words = kernels::random_words(
          options_.seed,
          {static_cast<std::uint32_t>(tick), static_cast<std::uint32_t>(tick >> 32), 0, 0});
      retreat_ = find_retreat(pilot_.passable(), corners_, robot_, words[0]);
    }
    if (retreat_.empty()) return robot_;
    const Cell to = retreat_.back();
    retreat_.pop_back();
    return to;
  }

  void end_trapped(const char* why) {
    result_.fault = Fault::trapped;
    end(Status::no_path, std::string("trapped: ") + why);
  }

  /// Obstacles that wait for the robot, or never move, close all ways, wherever it went aside; or
  /// those that move have left none open for long.
  bool trapped() {
    if (waited_ >= Headway::kLongWait) return true;
    return !joined(World::Without::those_that_move) && ++attempts_ > kAttempts;
  }

  void go(Cell to) {
    before_ = robot_;
    const Grid& passable = world_.passable();
    if (passable.blocked(to) ||
        !diagonal_allowed(passable, corners_, {to.x, robot_.y}, {robot_.x, to.y})) {
      bump(to);
      to = robot_;
    }
    if (to == robot_) {
      ++result_.waits;
    } else {
      result_.length += distance(robot_, to);
      result_.cost += pilot_.move_cost(robot_, to);
    }
    robot_ = to;
    result_.track.push_back(to);
  }

  /// What was not seen, but is in the way, is felt.
  void bump(Cell to) {
    retreat_.clear();
    learn(world_.felt({robot_, to}), true);
  }

  /// True where the observer ends the drive.
  bool show(Found found) {
    if (!observer_) return false;
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
    observer_(view);
    return view.stopped();
  }

  static constexpr int kPatience = 16;  // ticks without a way, then the robot moves aside
  static constexpr int kAttempts = 64;  // to move aside for what waits for the robot
  static constexpr int kDoubts = 64;    // of what was learned, then of the whole map

  const Grid& map_;
  const DriveOptions& options_;
  const StopCondition& stop_;
  const DriveObserver& observer_;
  const Corners corners_;
  World world_;
  Pilot& pilot_;
  Cell robot_, before_;  // before its last move
  std::int64_t tick_ = 0;
  const Way* way_ = nullptr;
  News seen_;
  std::vector<Cell> news_;
  bool replanned_ = false, arrived_ = false;
  Headway headway_{map_.width(), map_.height()};
  Milliseconds planning_{};
  int waited_ = 0, attempts_ = 0, doubts_ = 0;
  std::int64_t doubted_at_ = 0;  // tick
  std::int64_t joined_at_ = -1;  // tick of the last change then
  Cell joined_from_;
  bool joined_ = false;
  std::vector<Cell> retreat_;  // the next cell last
  bool ended_ = false;
  DriveResult result_;
};

}  // namespace

DriveResult drive(const Grid& map, const Grid& truth, Cell start, Cell goal, const Changes& changes,
                  const DriveOptions& options, const NavigatorOptions& navigator,
                  const StopCondition& stop, const DriveObserver& observer) {
  check_drive(map, truth, options);
  Navigator pilot(map, goal, navigator);
  return Drive(map, truth, start, pilot, changes, options, stop, observer).run();
}

DriveResult drive(Pilot& pilot, const Grid& truth, Cell start, const Changes& changes,
                  const DriveOptions& options, const StopCondition& stop,
                  const DriveObserver& observer) {
  const Grid map = pilot.map();
  check_drive(map, truth, options);
  return Drive(map, truth, start, pilot, changes, options, stop, observer).run();
}

}  // namespace lasius
