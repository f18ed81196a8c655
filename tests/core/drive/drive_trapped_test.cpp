// Drives that end as trapped, and a pilot that takes its time.
#include <gtest/gtest.h>

#include <chrono>
#include <span>

#include "lasius/base/error.h"
#include "lasius/drive/drive.h"
#include "tests/oracle/drive/drive_checker.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

TEST(Drive, TrappedByWhatNeverGoesAway) {
  const Grid map(7, 1);
  Changes changes;
  changes.obstacles = {{.tick = 0, .speed = 0, .track = {{3, 0}}}};
  const DriveResult r = drive(map, map, {0, 0}, {6, 0}, changes);
  EXPECT_EQ(r.status, Status::no_path);
  EXPECT_EQ(r.fault, Fault::trapped);
  EXPECT_EQ(r.error, "trapped: moving obstacles stand in the way for good");
  EXPECT_EQ(r.track.size(), static_cast<std::size_t>(r.ticks) + 1);
  EXPECT_EQ(r.ticks, 65 * 16 - 1) << "goes aside every 16th tick, 64 times";
}

// Each corridor has an obstacle in it always, so none can be passed; out of sight it is forgotten.
TEST(Drive, TrappedBetweenCorridorsThatAreClosedInTurn) {
  const Grid map = drawn({"@@@@@@@@@@@@@@@",  //
                          "...............",  //
                          ".@@@@@@@@@@@@@.",  //
                          ".@@@@@@@@@@@@@.",  //
                          "...............",  //
                          "@@@@@@@@@@@@@@@"});
  Changes changes;
  for (const int y : {1, 4})
    changes.obstacles.push_back({.tick = 0, .speed = 0.5, .track = {{4, y}, {10, y}}});
  const DriveResult r = drive(map, map, {0, 2}, {14, 2}, changes, {.sense = 3});
  EXPECT_EQ(r.status, Status::no_path);
  EXPECT_EQ(r.fault, Fault::trapped);
  EXPECT_EQ(r.error, "trapped: moving obstacles close every way, for good or in turn");
  EXPECT_GT(r.ticks, 16'384);
  EXPECT_LT(r.ticks, 25'000);
  EXPECT_EQ(DriveChecker(map, changes, 0).fault(r.track), "");
  // It waits for a change that is to come, however late.
  changes.cells = {{.tick = r.ticks + 1000, .part = {1, 2, 13, 1}, .blocked = false}};
  EXPECT_EQ(drive(map, map, {0, 2}, {14, 2}, changes, {.sense = 3}).status, Status::solved);
}

/// Plans as a Navigator does, but has not done so before a tick; waits there. To observe takes it 3
/// seconds, by the clock that it is.
class SlowPilot final : public Pilot, public TimeSource {
 public:
  SlowPilot(const Grid& map, Cell goal, int ready) : pilot_(map, goal), left_(ready) {}
  void observe(const Rectangle& part, bool blocked) override { pilot_.observe(part, blocked); }
  void observe(std::span<const Cell> cells, bool blocked) override {
    pilot_.observe(cells, blocked);
    now_ += std::chrono::seconds(3);
  }
  const Way& step(Cell robot, const StopCondition& stop) override {
    left = stop.deadline - stop.now();
    if (left_-- <= 0) return pilot_.step(robot, {});
    none_.status = Status::limit;
    return none_;
  }
  Cell goal() const noexcept override { return pilot_.goal(); }
  const Grid& map() const noexcept override { return pilot_.map(); }
  const Grid& passable() const noexcept override { return pilot_.passable(); }
  bool connected(Cell a, Cell b) override { return pilot_.connected(a, b); }
  Clock::time_point now() const noexcept override { return now_; }

  Clock::duration left{};  ///< for the last step

 private:
  Navigator pilot_;
  int left_;  // steps without a way
  Way none_;
  Clock::time_point now_;
};

/// A walk that leaves cells out.
class JumpingPilot final : public Pilot {
 public:
  explicit JumpingPilot(const Grid& map) : pilot_(map, {14, 2}) {}
  void observe(const Rectangle& part, bool blocked) override { pilot_.observe(part, blocked); }
  void observe(std::span<const Cell> cells, bool blocked) override {
    pilot_.observe(cells, blocked);
  }
  const Way& step(Cell robot, const StopCondition& stop) override {
    way_ = pilot_.step(robot, stop);
    way_.walk = {robot, {robot.x + 6, robot.y}};
    return way_;
  }
  Cell goal() const noexcept override { return pilot_.goal(); }
  const Grid& map() const noexcept override { return pilot_.map(); }
  const Grid& passable() const noexcept override { return pilot_.passable(); }
  bool connected(Cell a, Cell b) override { return pilot_.connected(a, b); }

 private:
  Navigator pilot_;
  Way way_;
};

TEST(Drive, RefusesAPilotWhoseWalkLeavesCellsOut) {
  const Grid map(16, 5);
  JumpingPilot pilot(map);
  EXPECT_THROW((void)drive(pilot, map, {0, 2}), Error);
}

TEST(Drive, IsNotTrappedWhileItPlans) {
  const Grid map(60, 60);
  Changes changes;
  changes.obstacles = {{.tick = 0, .speed = 1, .track = {{50, 50}, {55, 50}}}};
  SlowPilot pilot(map, {9, 1}, 20'000);
  EXPECT_EQ(drive(pilot, map, {1, 1}, changes).status, Status::solved);
}

TEST(Drive, MeasuresPlanningByTheClockOfItsDeadline) {
  SlowPilot pilot(Grid(9, 1), {5, 0}, 0);
  const DriveResult r = drive(pilot, drawn({".......@."}), {1, 0}, {},
                              {.max_ticks = 0, .seconds_per_tick = 10, .stop = {.time = &pilot}});
  EXPECT_EQ(pilot.left, std::chrono::seconds(7));
  ASSERT_EQ(r.replans.size(), 1u);
  EXPECT_EQ(r.replans[0].ms, 3000);
  EXPECT_EQ(r.planning_ms, 3000);
}

}  // namespace
}  // namespace lasius
