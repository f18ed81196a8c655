#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "tests/core/arm/questions.h"
#include "tests/core/base/refusal.h"

// What a search among postures asks, how long it goes on, and what it makes short.
namespace lasius::arm {
namespace {

TEST(ArmPostures, ThreadsChangeNothing) {
  Case c = make_case("industrial6", 3, 15, 0.8, 12);
  const SceneSensor sensor(c.robot, c.scene);
  Params p = in_lattice();
  p.iterations = 6;
  p.prove = false;
  p.leash = 0;
  std::vector<Result> results;
  for (const int threads : {1, 2, 5}) {
    p.threads = threads;
    results.push_back(plan(c.robot, sensor, c.request, p));
  }
  ASSERT_GT(results[0].joints.cols(), 0) << results[0].error;
  for (const Result& r : results) {
    EXPECT_EQ(r.joints, results[0].joints);
    EXPECT_EQ(r.asked, results[0].asked);
    EXPECT_EQ(r.mean, results[0].mean);
    EXPECT_EQ(r.trajectory.duration(), results[0].trajectory.duration());
  }
  EXPECT_EQ(results[0].asked.size(), static_cast<std::size_t>(results[0].iterations));
  EXPECT_EQ(results[0].asked.back().positions, results[0].questions.positions);
}

// Ants that get nowhere in the steps that they may take leave it to random values to get past.
TEST(ArmPostures, GetsPastByRandomValuesWhereAntsDoNotArrive) {
  const Case c = make_case("industrial6", 3, 15, 0.8, 12);
  const SceneSensor sensor(c.robot, c.scene);
  Params p = in_lattice();
  p.leash = 0.01;
  p.vias = 200;
  const Result r = plan(c.robot, sensor, c.request, p);
  ASSERT_EQ(r.status, Status::solved) << r.error;
  EXPECT_EQ(r.iterations, 1);
  ASSERT_EQ(r.joints.cols(), 3);
  for (int i : {1, 2}) EXPECT_TRUE(sensor.motion_free(r.joints.col(i - 1), r.joints.col(i)));
  EXPECT_LT((tip_position(c.robot, last(r)) - c.request.goals[0].target.translation()).norm(),
            1e-6);
  EXPECT_EQ(recheck(c.robot, c.scene, r.trajectory).contacts, 0);
  p.vias = 0;
  EXPECT_GT(plan(c.robot, sensor, c.request, p).iterations, 1);
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
  Params p = in_lattice();
  const Counter all(scene);
  const Result whole = plan(c.robot, all, c.request, p);
  ASSERT_EQ(whole.status, Status::solved);
  const Questions& asked = whole.questions;
  EXPECT_EQ(asked.positions + asked.motions + asked.trajectory, all.asked);
  for (const int most : {1, 5, 60, 400}) {
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

// Where the coarse lattice has no way, a finer one is laid out.
TEST(ArmPostures, ThePitchIsHalvedWhereNothingIsFound) {
  const Robot robot = two_links();
  const Request request = across(robot);
  Params p("goritov2020");
  p.pitch = 0.12;
  p.joint_step = 0.13;  // moves of 0.12 ask for more
  p.threads = 1;
  const Result coarse = plan(robot, Nothing(), request, p);
  EXPECT_EQ(coarse.status, Status::no_path);
  expect_says(coarse.error, "pitch 0.12 m");
  p.refine = 3;
  const Result fine = plan(robot, Nothing(), request, p);
  EXPECT_EQ(fine.status, Status::solved) << fine.error;
  EXPECT_LT(fine.pitch, 0.12);
  EXPECT_EQ(fine.best.size(), static_cast<std::size_t>(fine.iterations));
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

// The proven optimum of a lattice takes a fraction of the questions that the source's settings ask;
// asked for lazily, fewer than by A*.
TEST(ArmPostures, TheOptimumTakesFewQuestions) {
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Case c = make_case("industrial6", seed, 12, 0.8, 10);
    const SceneSensor sensor(c.robot, c.scene);
    const Result source = plan(c.robot, sensor, c.request, c.parameters);
    if (source.status != Status::solved) continue;
    Params p = c.parameters;
    p.gamma = Params().gamma;
    p.ants = Params().ants;
    p.prove = p.scout = true;
    const Result few = plan(c.robot, sensor, c.request, p);
    const Result best = shortest_lattice_way(c.robot, sensor, c.request, p);
    const Result lazy = lazy_lattice_way(c.robot, sensor, c.request, p);
    ASSERT_EQ(few.status, Status::solved);
    EXPECT_NEAR(lazy.length, best.length, 1e-9);
    const auto count = [](const Result& r) { return r.questions.positions + r.questions.motions; };
    EXPECT_LE(count(lazy), count(best));
    EXPECT_LT(count(few), count(source) / 2);
    if (!few.optimal) continue;
    ++proven;
    EXPECT_NEAR(few.length, best.length, 1e-9);
    EXPECT_LT(few.iterations, p.iterations);
  }
  EXPECT_GE(proven, 3);
}

TEST(ArmPostures, WhatIsOptimisedIsTheLength) {
  const Case c = make_case("industrial6", 3, 12, 0.8, 10);
  const SceneSensor sensor(c.robot, c.scene);
  Params p = in_lattice();
  p.iterations = 8;
  for (const Objective objective : {Objective::joint, Objective::duration}) {
    p.objective = objective;
    Request request = c.request;
    request.motion = false;
    const Result r = plan(c.robot, sensor, request, p);
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
  p.objective = Objective::length;
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
