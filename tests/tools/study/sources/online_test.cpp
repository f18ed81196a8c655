// The worlds of the study `online`, its pilots, and a drive of it.
#include "tools/study/sources/online.h"

#include <gtest/gtest.h>

#include <set>

#include "bench/peers/dstar_pilot.h"
#include "lasius/base/error.h"
#include "lasius/path/shortest_walk.h"
#include "lasius/plan/planner.h"
#include "tools/study/description/study_file.h"
#include "tools/study/sources/online_pilots.h"
#include "tools/study/sources/online_worlds.h"

namespace lasius::study {
namespace {

bool joined(const Grid& grid, const OnlineWorld& world) {
  return Planner(grid).connected(world.start, world.goal);
}

bool differs(const Grid& a, const Grid& b) { return a.hash() != b.hash(); }

TEST(OnlineWorlds, AreJoinedAndOtherwiseThanTheMap) {
  const Study study = make_study("online");
  const auto& questions = study.experiments.front().questions;
  ASSERT_EQ(questions.size(), 12u);
  for (const Question& question : questions) {
    const bool moves = question.map.starts_with("warehouse");
    const bool shuts = question.map.starts_with("rooms") || question.map.starts_with("file");
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(question.map + ", seed " + std::to_string(seed));
      const OnlineWorld world = make_online_world(question.map, seed, LASIUS_MAPS_DIR);
      EXPECT_TRUE(joined(world.known, world));
      EXPECT_TRUE(joined(world.truth, world));
      EXPECT_TRUE(joined(all_shut(world), world));
      EXPECT_EQ(moves, !world.changes.obstacles.empty());
      EXPECT_EQ(shuts, !world.changes.cells.empty());
      EXPECT_TRUE(shuts || differs(world.known, world.truth));
      EXPECT_LE(std::max(world.known.width(), world.known.height()), 200);
    }
  }
}

TEST(OnlineWorlds, MapAndEndsAreTheNumbersTheRestIsTheSeeds) {
  for (const std::string family : {"city", "rooms", "warehouse", "noise"}) {
    const auto make = [&](int number, std::uint64_t seed) {
      return make_online_world(family + ' ' + std::to_string(number), seed, "");
    };
    const OnlineWorld one = make(1, 1), again = make(1, 1), other = make(1, 2), map = make(2, 1);
    EXPECT_EQ(one.truth, again.truth) << family;
    EXPECT_EQ(one.changes, again.changes) << family;
    EXPECT_EQ(one.known, other.known) << family;
    EXPECT_EQ(one.start, other.start) << family;
    EXPECT_TRUE(differs(one.truth, other.truth) || one.changes != other.changes) << family;
    EXPECT_TRUE(differs(one.known, map.known)) << family;
  }
  EXPECT_THROW(make_online_world("village 1", 1, ""), Error);
}

/// All doors that shut open again, and no wall does.
TEST(OnlineWorlds, DoorsOpenAgain) {
  const OnlineWorld world = make_online_world("rooms 1", 1, "");
  Grid grid = world.truth;
  int shut = 0;
  for (const bool shutting : {true, false}) {
    for (const Change& change : world.changes.cells) {
      if (change.blocked != shutting) continue;
      grid.fill(change.part, shutting);
      shut += shutting;
    }
  }
  EXPECT_EQ(grid, world.truth);
  EXPECT_GT(shut, 0);
}

/// A wall across 9 x 9 cells with one gap, which closes while another opens.
TEST(OnlinePilots, DStarLiteFindsTheGapAndTheWalkAroundIt) {
  Grid map(9, 9);
  map.fill({4, 0, 1, 9}, true);
  map.set_blocked({4, 0}, false);
  peers::DStarPilot pilot(map, {2, 8}, {6, 8});
  const Way& way = pilot.step({2, 8}, {});
  EXPECT_TRUE(way.replanned);
  EXPECT_NEAR(way.length, *shortest_walk(map, {2, 8}, {6, 8}, Neighbours::eight), 1e-3);
  EXPECT_FALSE(pilot.step({2, 8}, {}).replanned);
  pilot.observe(Rectangle{4, 0, 1, 1}, true);
  EXPECT_EQ(pilot.step({2, 8}, {}).status, Status::unreachable);
  EXPECT_FALSE(pilot.connected({2, 8}, {6, 8}));
  const Cell gap{4, 8};
  pilot.observe({&gap, 1}, false);
  EXPECT_NEAR(pilot.step({2, 8}, {}).length, 4, 1e-3);
  EXPECT_EQ(pilot.step({2, 8}, {}).walk.back(), (Cell{3, 8}));
  EXPECT_TRUE(pilot.map().free(gap));
}

TEST(OnlinePilots, AForgetfulOnePlansAnewAtEachChangeAndOnlyThen) {
  Grid map(20, 20);
  const NavigatorOptions exact{.params = Params("exact")};
  ForgetfulPilot forgetful(map, {18, 2}, exact);
  Navigator keeps(map, {18, 2}, exact);
  for (Pilot* pilot : {static_cast<Pilot*>(&forgetful), static_cast<Pilot*>(&keeps)}) {
    EXPECT_TRUE(pilot->step({1, 2}).replanned);
    EXPECT_FALSE(pilot->step({1, 2}).replanned);
    pilot->observe(Rectangle{5, 18, 2, 2}, true);  // far from the way
    EXPECT_EQ(pilot->step({1, 2}).replanned, pilot == &forgetful);
  }
}

/// Every contender, where time does not decide, on the smallest worlds.
TEST(OnlineDrives, EveryContenderArrivesAndDoesTheSameAgain) {
  const Study study = make_study("online");
  const OnlineDrives drives(study, LASIUS_MAPS_DIR);
  const Experiment& unhurried = study.experiments.front();
  ASSERT_EQ(unhurried.name, "unhurried");
  std::set<std::string> keys;
  for (const Contender& contender : unhurried.contenders) {
    const PreparedRun made = drives.prepare(unhurried.questions.front(), contender);
    EXPECT_TRUE(keys.insert(made.key).second) << contender.name;
    Workspace workspace;
    const auto run = made.run(1, false, {}, workspace), again = made.run(1, false, {}, workspace);
    EXPECT_EQ(run.status, Status::solved) << contender.name;
    EXPECT_GE(run.length, 1 - 1e-9) << contender.name;  // in a city nothing opens
    EXPECT_GT(run.iterations, 1) << contender.name;
    EXPECT_EQ(run.length, again.length) << contender.name;
    EXPECT_EQ(run.iterations, again.iterations) << contender.name;
  }
}

TEST(OnlineDrives, RefusesAnAlgorithmAndASettingThatItDoesNotKnow) {
  const Study study = make_study("online");
  const OnlineDrives drives(study, LASIUS_MAPS_DIR);
  const Question& question = study.experiments.front().questions.front();
  EXPECT_THROW((void)drives.prepare(question, {.name = "a", .algorithm = "no-such"}), Error);
  EXPECT_THROW(
      (void)drives.prepare(question, {.name = "a", .algorithm = "ras", .settings = {{"ant", "3"}}}),
      Error);
}

}  // namespace
}  // namespace lasius::study
