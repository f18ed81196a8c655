#include "lasius/drive/drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lasius/base/error.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/drive/drive_checker.h"
#include "tests/worlds/changing_world.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

std::vector<Cell> row_of_cells(int from, int to, int y) {
  std::vector<Cell> cells;
  for (int x = from; x <= to; ++x) cells.push_back({x, y});
  return cells;
}

DriveResult drive(const RandomWorld& w) {
  return drive(w.map, w.truth, w.start, w.goal, w.changes, w.options, w.navigator);
}

/// It arrived, and tells its track's length.
void expect_arrival(const DriveResult& r, Cell start, Cell goal) {
  EXPECT_EQ(r.track.front(), start);
  EXPECT_EQ(r.track.back(), goal);
  EXPECT_EQ(r.track.size(), static_cast<std::size_t>(r.ticks) + 1);
  double length = 0;
  for (std::size_t i = 1; i < r.track.size(); ++i) {
    length += std::hypot(r.track[i].x - r.track[i - 1].x, r.track[i].y - r.track[i - 1].y);
  }
  EXPECT_NEAR(r.length, length, 1e-9 * (1 + length));
}

TEST(Drive, GoesStraightWhereNothingIsInTheWay) {
  const Grid map(9, 3);
  const DriveResult r = drive(map, map, {1, 1}, {7, 1});
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_EQ(r.track, row_of_cells(1, 7, 1));
  EXPECT_EQ(r.ticks, 6);
  EXPECT_EQ(r.length, 6);
  EXPECT_EQ(r.seen, 0);
  ASSERT_EQ(r.replans.size(), 1u);
  EXPECT_EQ(r.replans[0].tick, 0);
  EXPECT_EQ(r.replans[0].length, 6);
}

TEST(Drive, WithANavigatorThatIsThereAlready) {
  int arrived = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const RandomWorld w = draw_world(seed, false);
    Navigator navigator(w.map, w.goal, w.navigator);
    const DriveResult own = drive(navigator, w.truth, w.start, w.changes, w.options);
    const DriveResult r = drive(w);
    EXPECT_EQ(own.track, r.track) << "seed " << seed;
    EXPECT_EQ(own.status, r.status) << "seed " << seed;
    EXPECT_EQ(own.replans.size(), r.replans.size()) << "seed " << seed;
    arrived += r.status == Status::solved;
  }
  EXPECT_GT(arrived, 0);
}

TEST(Drive, IsThereAtOnceWhereStartIsGoal) {
  const Grid map(3, 3);
  const DriveResult r = drive(map, map, {1, 1}, {1, 1});
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_EQ(r.track, std::vector<Cell>({{1, 1}}));
  EXPECT_EQ(r.length, 0);
}

TEST(Drive, LearnsAWallWhenItIsInSight) {
  const Grid truth = drawn({".........",  //
                            "....@....",  //
                            "....@....",  //
                            "....@...."});
  const Grid map(9, 4);
  const DriveResult r = drive(map, truth, {0, 2}, {8, 2}, {}, {.sense = 2});
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_EQ(r.seen, 2);  // the third stays behind the second, farther than 2 cells
  EXPECT_GT(r.replans.size(), 1u);
  EXPECT_GT(r.replans.back().tick, 0);
}

TEST(Drive, KnowsWhatItCoversThoughItSeesLess) {
  Grid map(9, 9);
  map.set_blocked({3, 3}, true);  // of which the truth knows nothing
  std::vector<Cell> learned;
  const auto look = [&](const DriveTick& tick) {
    if (tick.tick == 0) learned = tick.news;
  };
  const DriveResult r =
      drive(map, Grid(9, 9), {4, 4}, {7, 4}, {}, {.sense = 1, .observer = look}, {.radius = 1});
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_EQ(learned, std::vector<Cell>({{3, 3}}));
}

TEST(Drive, AnObstacleHidesWhatIsBehind) {
  const Grid truth = drawn({"@@@@@@@",  //
                            ".@.....",  //
                            "@@@@@@@"});
  const Grid map(7, 3);
  const DriveResult r = drive(map, truth, {0, 1}, {6, 1});
  EXPECT_EQ(r.status, Status::unreachable);
  EXPECT_EQ(r.seen, 3);  // of the walls the cells beside the robot, no more
  EXPECT_EQ(r.ticks, 0);
}

TEST(Drive, DoubtsTheMapWhereItKnowsNoOtherWay) {
  const Grid map = drawn({"..@.@..",  //
                          "..@.@..",  //
                          "..@.@.."});
  const Grid truth = drawn({"..@.@..",  //
                            "..@.@..",  //
                            "......."});
  // The doors are not in sight. A disc needs all to be three times as wide.
  for (const auto& [radius, by] : {std::pair{0.0, 1}, {0.4, 3}}) {
    const auto wide = [by = by](const Grid& grid) {
      return grid_of(by * grid.width(), by * grid.height(), [&](int x, int y) {
        return grid.blocked({x / by, y / by});
      });
    };
    const Cell start{by / 2, by / 2}, goal{6 * by + by / 2, by / 2};
    const DriveResult r =
        drive(wide(map), wide(truth), start, goal, {}, {.sense = 1}, {.radius = radius});
    EXPECT_EQ(r.status, Status::solved);
    EXPECT_EQ(DriveChecker(wide(truth), {}, radius).fault(r.track), "");
    EXPECT_GT(r.seen, 0);
  }
}

// The walls that it has seen are there for good, for nothing changes: it does not go back to them.
TEST(Drive, BelievesTheWallsThatItHasSeen) {
  const Grid map = walled(60, 9, {{30, 0, 1, 9}});
  Grid truth = map;
  truth.set_blocked({30, 8}, false);
  const DriveResult r = drive(map, truth, {25, 0}, {35, 0}, {}, {.sense = 6});
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_LT(r.length, 40);  // down along the wall, and up
  std::size_t turns = 0;    // up, on the near side
  for (std::size_t i = 1; i < r.track.size() && r.track[i].x < 30; ++i) {
    turns += r.track[i].y < r.track[i - 1].y;
  }
  EXPECT_EQ(turns, 0u);
}

TEST(Drive, AChangeWithoutEffectIsNone) {
  const Grid map = drawn({"..@..", "..@..", "..@.."});
  Changes changes;
  changes.cells = {{.tick = 0, .part = {2, 0, 1, 3}, .blocked = true}};
  const DriveResult r = drive(map, map, {0, 0}, {4, 2}, changes);
  EXPECT_EQ(r.status, Status::unreachable);
  EXPECT_EQ(r.ticks, 0);
}

TEST(Drive, NamesAFreeCellThatNothingStandsOn) {
  const Grid map = drawn({"@....", ".....", "....@"});
  Changes changes;
  changes.obstacles = {{.tick = 0, .speed = 0, .track = {{1, 0}}}};
  const DriveResult start = drive(map, map, {0, 0}, {3, 1}, changes);
  EXPECT_EQ(start.fault, Fault::start_blocked);
  EXPECT_EQ(start.nearest_free, (Cell{0, 1}));
  // For a goal it is free both in truth and on the map.
  const Grid wrong = drawn({".....", "...@@", "...@@"});
  const DriveResult far =
      drive(wrong, drawn({"....@", "....@", "....."}), {0, 0}, {4, 2}, {}, {.sense = 1});
  EXPECT_EQ(far.fault, Fault::goal_blocked);
  EXPECT_EQ(far.nearest_free, (Cell{2, 2}));
  EXPECT_EQ(drive(map, map, {2, 1}, {2, 2}).nearest_free, std::nullopt);
  EXPECT_EQ(drive(Grid(2, 1), drawn({"@@"}), {0, 0}, {1, 0}).nearest_free, std::nullopt);
}

TEST(Drive, UnreachableOnTheMapIsAnAnswerAtOnce) {
  const Grid map = drawn({"..@..", "..@..", "..@.."});
  const DriveResult r = drive(map, map, {0, 0}, {4, 2});
  EXPECT_EQ(r.status, Status::unreachable);
  EXPECT_EQ(r.fault, Fault::disconnected);
  EXPECT_NE(r.error, "");
}

TEST(Drive, WaitsForADoorThatOpens) {
  const Grid map = drawn({"..@..", "..@..", "..@.."});
  Changes changes;
  changes.cells = {{.tick = 30, .part = {2, 1, 1, 1}, .blocked = false}};
  const DriveResult r = drive(map, map, {0, 0}, {4, 2}, changes);
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_GE(r.ticks, 33);
  EXPECT_GT(r.waits, 0);
}

TEST(Drive, AChangeOfTheRobotsCellIsDeferred) {
  const Grid map(5, 1);
  Changes changes;
  changes.cells = {{.tick = 2, .part = {2, 0, 1, 1}, .blocked = true}};
  const DriveResult r = drive(map, map, {0, 0}, {4, 0}, changes);
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_EQ(r.track, row_of_cells(0, 4, 0));
  EXPECT_EQ(r.deferred_changes, 2);  // while it stands there, and while it leaves
}

TEST(Drive, GivesWayInACorridor) {
  const Grid map = drawn({".....@@@@@@@@",  //
                          ".............",  //
                          ".....@@@@@@@@"});
  Changes changes;
  changes.obstacles = {{.tick = 0, .speed = 1, .track = {{11, 1}, {1, 1}}}};
  const DriveResult r = drive(map, map, {6, 1}, {12, 1}, changes);
  EXPECT_EQ(r.status, Status::solved);
  EXPECT_EQ(DriveChecker(map, changes, 0).fault(r.track), "");
}

TEST(Drive, BlockedEndsAreToldApart) {
  const Grid map = drawn({"@..", "...", "..@"});
  EXPECT_EQ(drive(map, map, {0, 0}, {1, 1}).fault, Fault::start_blocked);
  EXPECT_EQ(drive(map, map, {1, 1}, {2, 2}).fault, Fault::goal_blocked);
  EXPECT_EQ(drive(map, map, {1, 1}, {3, 2}).fault, Fault::goal_outside);
  EXPECT_EQ(drive(map, map, {-1, 1}, {1, 1}).fault, Fault::start_outside);
  EXPECT_EQ(drive(map, map, {-1, 1}, {1, 1}).status, Status::invalid);
}

TEST(Drive, RefusesWhatMakesNoSense) {
  const Grid map(4, 4);
  const auto refuses = [&](const Changes& changes, const DriveOptions& options) {
    EXPECT_THROW((void)drive(map, map, {0, 0}, {3, 3}, changes, options), Error);
  };
  EXPECT_THROW((void)drive(map, Grid(4, 5), {0, 0}, {3, 3}), Error);
  refuses({.cells = {{.tick = 0, .part = {3, 3, 2, 1}}}, .obstacles = {}}, {});
  refuses({.cells = {{.tick = -1, .part = {3, 3, 1, 1}}}, .obstacles = {}}, {});
  refuses({.cells = {}, .obstacles = {{.speed = 1, .track = {}}}}, {});
  refuses({.cells = {}, .obstacles = {{.speed = -1, .track = {{0, 0}}}}}, {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses({}, {.sense = 0.5});
  refuses({}, {.sense = nan});
  refuses({}, {.max_ticks = -1});
  refuses({}, {.seconds_per_tick = 0});
  refuses({}, {.seed = std::uint64_t{1} << 53});
  EXPECT_THROW((void)drive(map, map, {0, 0}, {3, 3}, {}, {}, {.radius = -1}), Error);
}

TEST(Drive, EndsByTicksTokenAndDeadline) {
  const Grid map(9, 3);
  const DriveResult short_one = drive(map, map, {1, 1}, {7, 1}, {}, {.max_ticks = 3});
  EXPECT_EQ(short_one.status, Status::limit);
  EXPECT_EQ(short_one.limit, Limit::ticks);
  EXPECT_EQ(short_one.track.size(), 4u);
  EXPECT_EQ(drive(map, map, {1, 1}, {7, 1}, {}, {.stop = fired()}).status, Status::interrupted);
  const DriveResult late =
      drive(map, map, {1, 1}, {7, 1}, {}, {.stop = {.deadline = Clock::time_point::min()}});
  EXPECT_EQ(late.status, Status::limit);
  EXPECT_EQ(late.limit, Limit::time);
}

TEST(Drive, EndsWhereItsObserverStopsIt) {
  const Grid map(9, 3);
  const auto stop_at = [&](std::int64_t last) {
    return drive(map, map, {1, 1}, {7, 1}, {}, {.observer = [=](const DriveTick& tick) {
                   return tick.tick == last ? Go::stop : Go::on;
                 }});
  };
  const DriveResult r = stop_at(2);
  EXPECT_EQ(r.status, Status::interrupted);
  EXPECT_EQ(r.track, row_of_cells(1, 3, 1));
  EXPECT_EQ(r.length, 2);
  EXPECT_EQ(stop_at(6).status, Status::solved);  // it has arrived
}

TEST(Drive, NeverCollidesInRandomWorlds) {
  int solved = 0;
  std::int64_t ticks = 0;
  for (std::uint64_t seed = 0; seed < worlds(300); ++seed) {
    const RandomWorld w = draw_world(seed, false);
    const DriveResult r = drive(w);
    if (r.status == Status::invalid) continue;
    const double radius = w.navigator.radius;
    EXPECT_EQ(DriveChecker(w.truth, w.changes, radius).fault(r.track), "") << "seed " << seed;
    if (r.status == Status::solved) expect_arrival(r, w.start, w.goal);
    solved += r.status == Status::solved;
    ticks += r.ticks;
  }
  RecordProperty("ticks", std::to_string(ticks));
  EXPECT_GT(solved, 100);
}

TEST(Drive, ArrivesWhereTheTruthIsFixedAndJoined) {
  int joined = 0;
  for (std::uint64_t seed = 0; seed < worlds(400); ++seed) {
    const RandomWorld w = draw_world((1 << 20) + seed, true);
    const DriveResult r = drive(w);
    if (r.status == Status::invalid) continue;
    DriveChecker checker(w.truth, w.changes, w.navigator.radius);
    EXPECT_EQ(checker.fault(r.track), "") << "seed " << seed;
    if (r.status == Status::solved) {
      ++joined;
      expect_arrival(r, w.start, w.goal);
      continue;
    }
    EXPECT_EQ(r.status, Status::unreachable) << "seed " << seed;
    EXPECT_FALSE(checker.joined(r.track.back(), w.goal)) << "seed " << seed;
  }
  RecordProperty("arrived", joined);
  EXPECT_GT(joined, 200);
}

TEST(Drive, IsTheSameOnAnyNumberOfThreads) {
  RandomWorld w = draw_world(7, false);
  w.navigator.params = Params("acs");
  w.navigator.params.iterations = 5;
  w.options.max_ticks = 60;
  DriveResult first;
  for (const int threads : {1, 2, 5}) {
    w.navigator.params.threads = threads;
    DriveResult r = drive(w);
    if (threads == 1) first = r;
    EXPECT_EQ(r.track, first.track);
    EXPECT_EQ(r.replans.size(), first.replans.size());
  }
  EXPECT_GT(first.track.size(), 1u);
}

}  // namespace
}  // namespace lasius
