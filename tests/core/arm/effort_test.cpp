#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "tests/core/arm/questions.h"

// What a search among postures asks, how long it goes on, and what it makes short.
namespace lasius::arm {
namespace {

TEST(ArmPostures, ThreadsChangeNothing) {
  Case c = make_case("industrial6", 3, 15, 0.8, 12);
  const SceneSensor sensor(c.robot, c.scene);
  Params p = by_trees();
  std::vector<Result> results;
  for (const int threads : {1, 2, 5}) {
    p.threads = threads;
    results.push_back(plan(c.robot, sensor, c.request, p));
  }
  ASSERT_TRUE(results[0].trees) << results[0].error;
  for (const Result& r : results) {
    EXPECT_EQ(r.joints, results[0].joints);
    EXPECT_EQ(r.questions, results[0].questions);
    EXPECT_EQ(r.trajectory.duration(), results[0].trajectory.duration());
  }
}

/// Counts what it is asked.
class Counter final : public Sensor {
 public:
  explicit Counter(const Sensor& sensor) : sensor_(sensor) {}
  bool position_free(const JointRef& q) const override {
    ++asked;
    return sensor_.position_free(q);
  }
  bool motion_free(const JointRef& a, const JointRef& b) const override {
    ++asked;
    return sensor_.motion_free(a, b);
  }
  double clearance() const override { return sensor_.clearance(); }
  mutable std::atomic<int> asked{0};

 private:
  const Sensor& sensor_;
};

TEST(ArmPostures, NoMoreIsAskedThanMayBe) {
  const Case c = make_case("industrial6", 3, 15, 0.8, 12);
  const SceneSensor scene(c.robot, c.scene);
  Params p = by_trees();
  const Counter all(scene);
  const Result whole = plan(c.robot, all, c.request, p);
  ASSERT_EQ(whole.status, Status::solved);
  const Questions& asked = whole.questions;
  EXPECT_EQ(asked.positions + asked.motions + asked.trajectory, all.asked);
  for (const int most : {1, 5, 20, 40}) {
    ASSERT_LT(most, all.asked);
    const Counter sensor(scene);
    p.max_questions = most;
    p.threads = 4;
    const Result r = plan(c.robot, sensor, c.request, p);
    EXPECT_LE(sensor.asked, most);
    EXPECT_GE(sensor.asked, most - 1);
    EXPECT_EQ(r.status, Status::limit) << most << " " << r.error;
    EXPECT_EQ(r.limit, Limit::questions);
  }
}

/// Stands anywhere, moves nowhere.
class Stuck final : public Nothing {
 public:
  bool motion_free(const JointRef&, const JointRef&) const override { return false; }
};

TEST(ArmPostures, StraightLinesCountAsQuestions) {
  const Robot robot = two_links();
  Request request{.start = joints({0, 0.5}), .goals = {}};
  for (int i = 1; i < 10; ++i) request.goals.push_back(Goal::joints(joints({0.25 * i, 0.5})));
  for (const int most : {1, 2, 3, 4, 7, 12}) {
    Params p;
    p.max_questions = most;
    const Result r = plan(robot, Stuck(), request, p);
    EXPECT_EQ(r.status, Status::limit);
    EXPECT_EQ(r.limit, Limit::questions);
    EXPECT_EQ(r.questions.positions + r.questions.motions, most);
  }
}

TEST(ArmPostures, TreesThatDoNotMeetSaySo) {
  Params p;
  p.trees = 300;
  const Result r = plan(two_links(), Stuck(), across(two_links()), p);
  EXPECT_EQ(r.status, Status::no_path);
  EXPECT_EQ(r.error,
            "two trees of motions did not meet, after 300 joint values; try more (trees), or "
            "another seed");
  EXPECT_GE(r.questions.motions, 300);
}

// Among known obstacles trees ask less than ants do in a lattice, and find a way wherever ants do.
TEST(ArmPostures, TreesAskLessThanAnts) {
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Case c = make_case("industrial6", seed, 12, 0.8, 10);
    const SceneSensor sensor(c.robot, c.scene);
    const auto count = [](const Result& r) { return r.questions.positions + r.questions.motions; };
    const Result source = plan(c.robot, sensor, c.request, c.parameters);
    const Result trees = plan(c.robot, sensor, c.request, by_trees());
    if (source.status != Status::solved) continue;
    ++solved;
    ASSERT_EQ(trees.status, Status::solved) << seed;
    EXPECT_LT(count(trees), count(source) / 10);
  }
  EXPECT_GE(solved, 4);
}

TEST(ArmPostures, WhatIsOptimisedIsTheLength) {
  const Case c = make_case("industrial6", 3, 12, 0.8, 10);
  const SceneSensor sensor(c.robot, c.scene);
  // The source's one posture does not get past the plate.
  Case open = make_case("industrial6", 3, 10, 0, 10);
  const SceneSensor beside(open.robot, open.scene);
  open.parameters.iterations = 8;
  for (const bool trees : {true, false}) {
    Params p = trees ? by_trees() : open.parameters;
    Request request = trees ? c.request : open.request;
    request.motion = false;
    for (const Objective objective : {Objective::joint, Objective::duration}) {
      p.objective = objective;
      const Result r = plan(c.robot, trees ? sensor : beside, request, p);
      ASSERT_GT(r.joints.cols(), 0) << r.error;
      double joint = 0, seconds = 0;
      for (Eigen::Index i = 1; i < r.joints.cols(); ++i) {
        const JointVector change = r.joints.col(i) - r.joints.col(i - 1);
        joint += change.norm();
        double longest = 0;
        for (int j = 0; j < c.robot.size(); ++j)
          longest = std::max(longest, std::abs(change[j]) / c.robot.joints[j].velocity);
        seconds += longest;
      }
      EXPECT_NEAR(r.length, objective == Objective::joint ? joint : seconds, 1e-9);
      EXPECT_NEAR(r.joint_travel, joint, 1e-9);
      if (r.lower_bound) {
        EXPECT_LE(*r.lower_bound, r.length + 1e-9);
      }
    }
  }
  Params p = by_trees();
  const Result moved = plan(c.robot, sensor, c.request, p);
  EXPECT_EQ(moved.duration, moved.trajectory.duration());
  EXPECT_GT(moved.tip_travel, 0);
  p.shortcuts = 0;
  p.shortcut = false;
  const Result rough = plan(c.robot, sensor, c.request, p);
  EXPECT_LT(moved.joint_travel, rough.joint_travel);
}

TEST(ArmPostures, EveryObjectiveHasAName) { EXPECT_EQ(to_string(Objective::joint), "joint"); }

}  // namespace
}  // namespace lasius::arm
