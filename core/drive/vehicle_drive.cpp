#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/drive/changes_check.h"
#include "core/drive/drive_loop.h"
#include "core/drive/kept_way.h"
#include "core/drive/vehicle_window.h"
#include "core/grid/cell_set.h"
#include "core/vehicle/angle.h"
#include "core/vehicle/outline.h"
#include "kernels/base/random_stream.h"
#include "lasius/vehicle/drive.h"

namespace lasius::vehicle {
namespace {

Cell cell_of(const Pose& pose) {
  return {static_cast<int>(std::floor(pose.x)), static_cast<int>(std::floor(pose.y))};
}

/// A vehicle's Navigator as drives ask it: by the cell of the reference point.
class VehiclePilot final : public Pilot {
 public:
  VehiclePilot(const Grid& map, const Vehicle& vehicle, std::vector<Pose> goals,
               const NavigatorOptions& options)
      : navigator_(map, vehicle, std::move(goals), options), options_(options) {
    options_.costs.reset();  // the Navigator has them
  }

  void stand_at(const Pose& pose) { pose_ = pose; }
  double cost(const Segment& motion) const { return navigator_.cost(std::span(&motion, 1)); }
  const Way& way() const { return *own_; }
  /// What its Navigator asks, from where it stands.
  Request request(const StopCondition& stop) const {
    const std::span<const Pose> goals = navigator_.goals();
    return {.start = pose_,
            .goals = {goals.begin(), goals.end()},
            .goal_tolerance = options_.goal_tolerance,
            .heading_tolerance = options_.heading_tolerance,
            .weight = options_.weight,
            .smooth = false,
            .bound = false,
            .max_states = options_.max_states,
            .stop = stop};
  }

  void observe(const Rectangle& part, bool blocked) override { navigator_.observe(part, blocked); }
  void observe(std::span<const Cell> cells, bool blocked) override {
    navigator_.observe(cells, blocked);
  }
  const lasius::Way& step(Cell robot, const StopCondition& stop) override {
    own_ = &navigator_.step(pose_, stop);
    way_ = {};
    way_.status = own_->status;
    way_.fault = own_->fault;
    way_.error = own_->error;
    way_.replanned = own_->replanned;
    if (own_->segments.empty()) return way_;
    way_.length = own_->length;
    if (own_->over_costs) way_.cost = own_->cost;
    way_.walk = {robot};
    constexpr double kSpacing = 2;  // of what is shown
    for (const PathPose& at : poses(own_->segments, kSpacing))
      way_.path.push_back({at.pose.x, at.pose.y});
    return way_;
  }
  Cell goal() const noexcept override { return cell_of(navigator_.goals().front()); }
  const Grid& map() const noexcept override { return navigator_.map(); }
  const Grid& passable() const noexcept override { return navigator_.map(); }
  bool connected(Cell, Cell) override { return true; }  // the next question tells

 private:
  Navigator navigator_;
  NavigatorOptions options_;
  Pose pose_;
  const Way* own_ = nullptr;
  lasius::Way way_;
};

class VehicleDrive final : public DriveLoop {
 public:
  VehicleDrive(const Grid& map, const Grid& truth, const Vehicle& vehicle, const Pose& start,
               VehiclePilot& pilot, const Changes& changes, const DriveOptions& options)
      : DriveLoop(map, truth, cell_of(start), pilot, changes, options, true),
        vehicle_(vehicle),
        outline_(vehicle),
        around_(std::max(1.0, circumscribed_radius(vehicle))),
        vehicles_pilot_(pilot) {
    stand_at(start);
  }

  DriveResult run() {
    DriveResult result;
    static_cast<lasius::DriveResult&>(result) = DriveLoop::run();
    result.poses = std::move(poses_);
    result.moves = std::move(moves_);
    if (result.status == Status::solved) result.goal = vehicles_pilot_.way().goal;
    return result;
  }

 private:
  void stand_at(const Pose& pose) {
    pose_ = pose;
    poses_.push_back(pose);
    vehicles_pilot_.stand_at(pose);
    covered_ = met_cells(vehicle_, pose);
    swept_.insert(swept_.end(), covered_.begin(), covered_.end());
    gather(covered_, covers_);
    gather(swept_, holds_);
  }
  void gather(const std::vector<Cell>& cells, CellSet& set) const {
    set.reset(cells.size());
    for (const Cell c : cells)
      if (map_.contains(c)) set.add(c);
  }

  bool holds(const Rectangle& part) const override {
    const Rectangle near = Window::around(pose_, around_ + 3);
    const int right = std::min(part.x + part.width, near.x + near.width);
    const int bottom = std::min(part.y + part.height, near.y + near.height);
    for (int y = std::max(part.y, near.y); y < bottom; ++y)
      for (int x = std::max(part.x, near.x); x < right; ++x)
        if (holds_.has({x, y})) return true;
    return false;
  }
  bool covers(Cell cell) const override { return covers_.has(cell); }
  double reach() const override { return vehicle::circumscribed_radius(vehicle_) + 1.5; }

  bool blocked_at_start() override {
    const auto met =
        std::ranges::find_if(covered_, [&](Cell c) { return world_.now().blocked(c); });
    if (met != covered_.end()) {
      const bool outside = !world_.now().contains(robot_);
      end(Status::invalid, outside
                               ? "the start is outside the map"
                               : "at the start the vehicle touches cell (" +
                                     std::to_string(met->x) + ", " + std::to_string(met->y) + ")");
      result_.fault = outside ? Fault::start_outside : Fault::start_blocked;
      return true;
    }
    look();
    ask();
    if (way_->status != Status::invalid) return false;
    end(Status::invalid, way_->error);
    result_.fault = way_->fault;
    return true;
  }

  bool at_goal() const override { return false; }
  bool at_end_of_way() const override { return way_->length == 0 && !next_motion(); }
  bool goes() const noexcept override { return !way_->path.empty(); }
  bool proven() const noexcept override {
    return way_->path.empty() &&
           (way_->status == Status::unreachable || way_->status == Status::invalid ||
            way_->status == Status::no_path);
  }
  /// Walls that it knows may not be there: only what is there proves anything.
  void give_up() override {
    const Result& truth = *asked_[static_cast<std::size_t>(World::Without::all_obstacles)].way;
    const bool is_proven = truth.status == Status::unreachable;
    result_.fault = truth.fault;
    end(is_proven ? Status::unreachable : Status::no_path, truth.error);
  }

  /// Where it is stopped there may be a way.
  bool joined(World::Without without) override {
    Asked& asked = asked_[static_cast<std::size_t>(without)];
    Grid walls = world_.walls(without);
    if (!asked.way || asked.from != pose_ || asked.walls != walls) {
      asked.way.reset();
      if (!truths_ || truths_walls_ != walls) {
        std::optional<Planner> planner = truths_ ? truths_->on(walls, options_.stop)
                                                 : Planner::make(walls, vehicle_, options_.stop);
        if (!planner) return true;
        truths_ = std::move(planner);
        truths_walls_ = walls;
      }
      Result way = truths_->plan(vehicles_pilot_.request(options_.stop));
      if (way.segments.empty() && options_.stop.poll() != StopCondition::Cause::none) return true;
      asked = {std::move(walls), pose_, std::move(way)};
    }
    return !asked.way->segments.empty();
  }

  /// The next of the way, of at most a cell.
  std::optional<Segment> next_motion() const {
    for (const Segment& s : vehicles_pilot_.way().segments)
      if (s.extent() > 0) return piece(s);
    return std::nullopt;
  }
  Segment piece(const Segment& s) const {
    return begin_of(s, std::min(s.extent(), s.gear == 0 ? 1 / around_ : 1.0));
  }

  void follow() override {
    const std::optional<Segment> motion = next_motion();
    // What it knows is not looked at: the way keeps clear of that, by less than pieces of it show.
    const auto news = [&](Cell c) { return world_.now().blocked(c) && pilot_.map().free(c); };
    if (!motion || !go(*motion, news)) stand();
  }
  void stand() override {
    holds_ = covers_;
    poses_.push_back(pose_);
    arrive(robot_, false, 0, 0);
  }
  /// False where what bars it is in the way, which then is felt.
  template <class Bars>
  bool go(const Segment& motion, const Bars& bars) {
    const Window window(vehicle_, Window::around(motion.begin, around_ + 3), bars);
    if (const auto contact = window.first_contact(motion)) {
      if (pilot_.map().free(contact->cell)) learn({contact->cell}, true);
      return false;
    }
    swept_.clear();
    sweep(motion);
    moves_.push_back(motion);
    stand_at(motion.end());
    arrive(cell_of(pose_), true, motion.length, vehicles_pilot_.cost(motion));
    return true;
  }
  /// Holds what a motion meets: pieces of the sweep lie in the footprint at their middle, grown.
  void sweep(const Segment& motion) {
    constexpr int kPieces = 4;
    const double extent = motion.extent();
    const double reach =
        motion.gear == 0 ? extent * around_ : extent * (1 + motion.sharpest() * around_);
    for (int i = 0; i < kPieces; ++i) {
      const Pose middle = motion.pose(extent * (i + 0.5) / kPieces);
      (void)outline_.visit_cells(middle, reach / kPieces / 2, [&](int row, int first, int last) {
        for (int x = first; x <= last; ++x) swept_.push_back({x, row});
        return false;
      });
    }
  }

  /// The longest of some motions, as far as they meet nothing that is known.
  void set_out() override {
    constexpr std::uint32_t kDrawn = 8;
    const double most = 2 * around_ + 8;
    const Window window(vehicle_, Window::around(pose_, most + around_ + 2),
                        [&](Cell c) { return pilot_.map().blocked(c); });
    const auto tick = static_cast<std::uint64_t>(tick_);
    aside_.reset();
    for (std::uint32_t i = 0; i < kDrawn; ++i) {
      const auto words = kernels::random_words(
          options_.seed,
          {static_cast<std::uint32_t>(tick), static_cast<std::uint32_t>(tick >> 32), i, 0});
      const auto share = [&](std::size_t word) { return words[word] * 0x1p-32; };
      Segment motion{.begin = pose_, .length = most};
      motion.gear = vehicle_.reverse && share(0) < 0.5 ? -1 : 1;
      if (vehicle_.turning_radius > 0)
        motion.curvature = (2 * share(1) - 1) / vehicle_.turning_radius;
      if (vehicle_.sideways) motion.angle = half_turned(kTurn * share(1));
      if (vehicle_.rotate_in_place && share(2) < 0.25) {
        motion = {.begin = pose_, .length = 0, .gear = 0, .angle = kPi * (2 * share(1) - 1)};
      }
      if (const auto contact = window.first_contact(motion)) {
        const double short_of = motion.gear == 0 ? 1 / around_ : 1;  // and not right to it
        motion = begin_of(motion, std::max(0.0, contact->at - short_of));
      }
      if (!aside_ || motion.extent() > aside_->extent()) aside_ = motion;
    }
  }
  void go_aside() override {
    const bool any = aside_ && aside_->extent() > 1e-9;
    const std::optional<Segment> motion = any ? std::optional(piece(*aside_)) : std::nullopt;
    // It may have learned of walls since it set out.
    if (motion && go(*motion, [&](Cell c) { return world_.now().blocked(c); })) {
      aside_ = rest_of(*aside_, motion->extent());
      return;
    }
    aside_.reset();
    stand();
  }
  void settle() override { aside_.reset(); }

  const Vehicle& vehicle_;
  const Outline outline_;
  const double around_;  ///< radius of the circle about the footprint, at least 1
  VehiclePilot& vehicles_pilot_;
  Pose pose_;
  std::vector<Pose> poses_;
  std::vector<Segment> moves_;
  std::vector<Cell> covered_, swept_;  ///< where it stands; and what it swept in its last move
  CellSet covers_, holds_;             ///< the same, on the map
  struct Asked {
    Grid walls{1, 1};
    Pose from;
    std::optional<Result> way;
  };
  std::array<Asked, 3> asked_;     ///< without what, of what is there
  std::optional<Planner> truths_;  ///< on what was asked of last
  Grid truths_walls_{1, 1};
  std::optional<Segment> aside_;
};

}  // namespace

DriveResult drive(const Grid& map, const Grid& truth, const Vehicle& vehicle, const Pose& start,
                  std::vector<Pose> goals, const Changes& changes, const DriveOptions& options,
                  const NavigatorOptions& navigator) {
  check_drive(map, truth, options);
  require_pose(start, "a coordinate of the start");
  for (const Pose& goal : goals) require_pose(goal, "a coordinate of a goal");
  NavigatorOptions how = navigator;
  how.doubt_after = 0;
  VehiclePilot pilot(map, vehicle, std::move(goals), how);
  return VehicleDrive(map, truth, vehicle, start, pilot, changes, options).run();
}

}  // namespace lasius::vehicle
