#include "lasius/drive/drive.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/drive/changes_check.h"
#include "core/drive/drive_loop.h"
#include "core/drive/path_walker.h"
#include "core/drive/retreat.h"
#include "core/grid/cell_distance.h"
#include "core/grid/components.h"
#include "core/grid/move_rule.h"
#include "core/plan/answer.h"
#include "kernels/base/random_stream.h"

namespace lasius {
namespace {

/// A point or disc that goes from cell to cell.
class CellDrive final : public DriveLoop {
 public:
  CellDrive(const Grid& map, const Grid& truth, Cell start, Pilot& pilot, const Changes& changes,
            const DriveOptions& options)
      : DriveLoop(map, truth, start, pilot, changes, options, false),
        corners_(rule_of_walks(pilot.corners())),
        before_(start) {}

 private:
  bool holds(const Rectangle& part) const override { return world_.held({before_, robot_}, part); }
  bool covers(Cell cell) const override { return world_.growth().blocks(robot_, cell); }
  double reach() const override { return 1.5 * world_.growth().reach(); }
  bool at_goal() const override { return robot_ == pilot_.goal(); }
  bool at_end_of_way() const override { return way_->goal_reached == robot_; }

  bool blocked_at_start() override {
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
    std::function<bool(Cell)> near;
    if (grid.free(other)) {
      components.emplace(grid, connectivity_of(corners_));
      near = [&](Cell c) { return components->connected(grid, other, c); };
    }
    find_nearest(result_, grid, cell, options_.stop.token, near);
    return true;
  }
  /// A way leads near enough to the goal, as far as is known.
  bool near_goal() {
    if (pilot_.goal_tolerance() > 0) ask();
    return way_ != nullptr && !way_->path.empty();
  }

  /// Of a disc's path there may be no walk: then there is none.
  bool goes() const noexcept override {
    return !way_->path.empty() && (pilot_.radius() == 0 || way_->walk.size() > 1 ||
                                   robot_ == way_->goal_reached.value_or(pilot_.goal()));
  }
  bool proven() const noexcept override {
    return way_->status == Status::unreachable || way_->status == Status::invalid ||
           (!way_->path.empty() && !goes());
  }
  void give_up() override {
    end(Status::unreachable, "as far as is known, no way leads from " + cell_name(robot_) +
                                 " to the goal " + cell_name(pilot_.goal()));
    result_.fault = way_->fault;
  }

  /// Looks at the whole map; without obstacles only where that has changed, or the robot moved.
  bool joined(World::Without without) override {
    if (without != World::Without::all_obstacles)
      return world_.joined(robot_, pilot_.goal(), corners_, without);
    if (joined_at_ != world_.still_changed_at() || joined_from_ != robot_) {
      joined_at_ = world_.still_changed_at();
      joined_from_ = robot_;
      joined_ = world_.joined(robot_, pilot_.goal(), corners_, without);
    }
    return joined_;
  }

  void follow() override {
    if (way_->walk.size() < 2) return go(robot_);
    const Cell next = way_->walk[1];
    if (std::abs(std::int64_t{next.x} - robot_.x) > 1 ||
        std::abs(std::int64_t{next.y} - robot_.y) > 1)
      refuse("the pilot's walk does not go on in a neighbour of the robot's cell",
             "give each cell of the way in Way::walk");
    go(next);
  }
  void stand() override { go(robot_); }
  void set_out() override {
    const auto tick = static_cast<std::uint64_t>(tick_);
    const auto words = kernels::random_words(
        options_.seed,
        {static_cast<std::uint32_t>(tick), static_cast<std::uint32_t>(tick >> 32), 0, 0});
    retreat_ = find_retreat(pilot_.passable(), corners_, robot_, words[0]);
  }
  void go_aside() override {
    if (retreat_.empty()) return go(robot_);
    const Cell to = retreat_.back();
    retreat_.pop_back();
    go(to);
  }
  void settle() override { retreat_.clear(); }

  void go(Cell to) {
    before_ = robot_;
    const Grid& passable = world_.passable();
    if (passable.blocked(to) ||
        !diagonal_allowed(passable, corners_, {to.x, robot_.y}, {robot_.x, to.y})) {
      // What was not seen, but is in the way, is felt.
      retreat_.clear();
      learn(world_.felt({robot_, to}), true);
      to = robot_;
    }
    const bool moves = to != robot_;
    arrive(to, moves, moves ? distance(robot_, to) : 0, moves ? pilot_.move_cost(robot_, to) : 0);
  }

  const Corners corners_;
  Cell before_;                  // before its last move
  std::int64_t joined_at_ = -1;  // tick of the last change then
  Cell joined_from_;
  bool joined_ = false;
  std::vector<Cell> retreat_;  // the next cell last
};

}  // namespace

DriveResult drive(const Grid& map, const Grid& truth, Cell start, Cell goal, const Changes& changes,
                  const DriveOptions& options, const NavigatorOptions& navigator) {
  check_drive(map, truth, options);
  Navigator pilot(map, goal, navigator);
  return CellDrive(map, truth, start, pilot, changes, options).run();
}

DriveResult drive(Pilot& pilot, const Grid& truth, Cell start, const Changes& changes,
                  const DriveOptions& options) {
  const Grid map = pilot.map();
  check_drive(map, truth, options);
  return CellDrive(map, truth, start, pilot, changes, options).run();
}

}  // namespace lasius
