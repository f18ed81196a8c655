#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <random>
#include <utility>
#include <vector>

#include "core/arm/ends.h"
#include "tests/core/arm/questions.h"

// What `postures` adds to the source's system: more than one posture a point, goals of other kinds.
namespace lasius::arm {
namespace {

JointVector random_values(const Robot& robot, std::mt19937& engine) {
  JointVector q(robot.size());
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    q[j] = std::uniform_real_distribution<double>(std::max(joint.low, -3.0),
                                                  std::min(joint.high, 3.0))(engine);
  }
  return q;
}

/// The tip's frame by KDL.
KDL::Frame frame_by_kdl(const Robot& robot, const JointVector& q) {
  KDL::Chain chain;
  const auto frame = [](const Pose& pose) {
    const Eigen::Matrix3d r = pose.linear();
    return KDL::Frame(KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0),
                                    r(2, 1), r(2, 2)),
                      KDL::Vector(pose(0, 3), pose(1, 3), pose(2, 3)));
  };
  for (const Joint& joint : robot.joints) {
    const KDL::Vector axis(joint.axis.x(), joint.axis.y(), joint.axis.z());
    const bool slides = joint.kind == Joint::Kind::prismatic;
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(joint.frame)));
    chain.addSegment(KDL::Segment(KDL::Joint(
        KDL::Vector::Zero(), axis, slides ? KDL::Joint::TransAxis : KDL::Joint::RotAxis)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(robot.tip)));
  KDL::JntArray values(static_cast<unsigned>(robot.size()));
  for (int j = 0; j < robot.size(); ++j) values(static_cast<unsigned>(j)) = q[j];
  KDL::Frame tip;
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(values, tip);
  return tip;
}

/// A lattice search without the straight line, quick enough for a test.
Params in_lattice() {
  Params p;
  p.direct = false;
  p.threads = 1;
  return p;
}

JointVector last(const Result& result) { return result.joints.col(result.joints.cols() - 1); }

// In an empty scene what the arm can reach is reached, from where it is stretched out, too.
TEST(ArmPostures, ReachesWhateverJointValuesReach) {
  const Nothing sensor;
  std::mt19937 engine(4);
  for (const char* name : {"two", "planar3", "industrial6", "redundant7"}) {
    const Robot robot = name == std::string("two") ? two_links() : shipped(name);
    for (int i = 0; i < 25; ++i) {
      const JointVector start =
          i % 2 == 0 ? JointVector(JointVector::Zero(robot.size())) : random_values(robot, engine);
      const Eigen::Vector3d goal = tip_position(robot, random_values(robot, engine));
      for (const bool direct : {true, false}) {
        if (!direct && i % 5 != 0) continue;
        Params p = in_lattice();
        p.direct = direct;
        const Result r = plan(robot, sensor, {.start = start, .goals = {goal}}, p);
        ASSERT_EQ(r.status, Status::solved) << name << " " << i << " " << r.error;
        EXPECT_EQ(r.direct, direct);
        EXPECT_EQ(r.goal, 0);
        EXPECT_LT((tip_position(robot, last(r)) - goal).norm(), 1e-6);
        EXPECT_EQ(r.joints.col(0), start);
        if (direct) {
          EXPECT_EQ(r.questions.positions + r.questions.motions, 3);
        }
      }
    }
  }
}

// Elbow up and elbow down: the source's one posture does not get to the goal, which touches a ball
// in it.
TEST(ArmPostures, ChangesToThePostureThatIsFree) {
  const Robot robot = two_links();
  const JointVector start = joints({0.3, 1.2}), goal = joints({1, -1.2});
  // In the way of the forearm at the goal where the elbow is as at the start.
  const Eigen::Vector3d tip = tip_position(robot, goal);
  Obstacle ball;
  ball.shape = Solid::Shape::sphere;
  ball.radius = 0.05;
  const double other = 2 * std::atan2(tip.y(), tip.x()) - goal[0];
  ball.pose.translation() =
      0.5 * (tip + Eigen::Vector3d(0.5 * std::cos(other), 0.5 * std::sin(other), 0));
  const SceneSensor sensor(robot, {"", {ball}});
  const Request request{.start = start, .goals = {tip}};
  const Result source = plan(robot, sensor, request, Params("goritov2020"));
  EXPECT_NE(source.status, Status::solved);
  for (const bool direct : {true, false}) {
    Params p = in_lattice();
    p.direct = direct;
    const Result r = plan(robot, sensor, request, p);
    ASSERT_EQ(r.status, Status::solved) << r.error;
    EXPECT_LT(largest_change(last(r), goal), 1e-5);
    EXPECT_EQ(recheck(robot, {"", {ball}}, r.trajectory).contacts, 0);
  }
}

TEST(ArmPostures, GoalsArePosesJointValuesAndSeveral) {
  const Robot robot = shipped("industrial6");
  const Nothing sensor;
  const JointVector start = joints({0.1, 0.2, 0.3, 0, 0.4, 0}),
                    there = joints({-1, 0.5, 0.8, 0.4, -0.9, 1});
  const Pose pose = tip_pose(robot, there);
  const KDL::Frame wanted = frame_by_kdl(robot, there);
  for (const bool direct : {true, false}) {
    Params p = in_lattice();
    p.direct = direct;
    const Result posed = plan(robot, sensor, {.start = start, .goals = {Goal::pose(pose)}}, p);
    ASSERT_EQ(posed.status, Status::solved) << posed.error;
    const KDL::Twist off = KDL::diff(frame_by_kdl(robot, last(posed)), wanted);
    EXPECT_LT(off.vel.Norm(), 1e-6);
    EXPECT_LT(off.rot.Norm(), 1e-6);
    // Looser, and tighter than any posture but one.
    const Result loose =
        plan(robot, sensor, {.start = start, .goals = {Goal::pose(pose, 0.01, 0.5)}}, p);
    ASSERT_EQ(loose.status, Status::solved);
    const KDL::Twist about = KDL::diff(frame_by_kdl(robot, last(loose)), wanted);
    EXPECT_LE(about.vel.Norm(), 0.01);
    EXPECT_LE(about.rot.Norm(), 0.5);

    const Result joined = plan(robot, sensor, {.start = start, .goals = {Goal::joints(there)}}, p);
    ASSERT_EQ(joined.status, Status::solved);
    EXPECT_EQ(last(joined), there);
    // The first cannot be reached, the third is nearest.
    const Eigen::Vector3d far(9, 0, 0);
    const Request several{.start = start,
                          .goals = {far, Goal::joints(there), Goal::joints(start * 1.2)}};
    const Result one = plan(robot, sensor, several, p);
    ASSERT_EQ(one.status, Status::solved);
    EXPECT_EQ(one.goal, 2);
    EXPECT_EQ(last(one), several.goals[2].values);
  }
}

TEST(ArmPostures, AFreeJointTurnsTheShortWay) {
  Robot robot = two_links();
  robot.joints[0].continuous = true;
  robot.joints[0].low = -1000;
  robot.joints[0].high = 1000;
  const Result r =
      plan(robot, Nothing(), {.start = joints({3, 1}), .goals = {Goal::joints(joints({-3, 1}))}});
  ASSERT_EQ(r.status, Status::solved);
  EXPECT_NEAR(last(r)[0], 2 * 3.14159265358979 - 3, 1e-12);
}

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
  EXPECT_NE(coarse.error.find("pitch 0.12 m"), std::string::npos) << coarse.error;
  p.refine = 3;
  const Result fine = plan(robot, Nothing(), request, p);
  EXPECT_EQ(fine.status, Status::solved) << fine.error;
  EXPECT_LT(fine.pitch, 0.12);
  EXPECT_EQ(fine.best.size(), static_cast<std::size_t>(fine.iterations));
}

TEST(ArmPostures, EveryPostureThatTouchesIsAFaultOfTheGoal) {
  const Robot robot = two_links();
  Obstacle ball;
  ball.shape = Solid::Shape::sphere;
  ball.radius = 0.05;
  ball.name = "ball";
  const Request request = across(robot);
  ball.pose.translation() = request.goals[0].target.translation();
  const Result r = plan(robot, SceneSensor(robot, {"", {ball}}), request);
  EXPECT_EQ(r.status, Status::invalid);
  EXPECT_EQ(r.fault, Fault::goal_blocked);
  EXPECT_NE(r.error.find("in each of 2 postures found"), std::string::npos) << r.error;
}

TEST(ArmPostures, NoPosturesAreLookedForOnceToldToStop) {
  const Robot robot = two_links();
  std::stop_source source;
  Request request = across(robot);
  request.stop.token = source.get_token();
  const std::array<int, 1> only{0};
  const auto found = [&] {
    return find_ends(robot, Kinematics(robot), request, only, 1, 0, 64, 8).size();
  };
  EXPECT_EQ(found(), 2u);
  source.request_stop();
  EXPECT_EQ(found(), 0u);
}

TEST(ArmPostures, JointsAreTurnedByWholeTurnsTowardsTheStart) {
  Robot robot = two_links();
  for (Joint& joint : robot.joints) joint.low = -6, joint.high = 6;
  const Request request = across(robot);
  const std::array<int, 1> only{0};
  const auto ends = find_ends(robot, Kinematics(robot), request, only, 1, 0, 64, 8);
  ASSERT_EQ(ends.size(), 2u) << "and none is told twice";
  for (const End& end : ends) EXPECT_LE(largest_change(end.q, request.start), 3.1416);
}

TEST(ArmPostures, AGoalIsNotBlockedWhereOneOfItsPosturesIs) {
  const Robot robot = two_links();
  const Request request = across(robot);
  const std::array<int, 1> only{0};
  const auto ends = find_ends(robot, Kinematics(robot), request, only, 1, 0, 64, 8);
  ASSERT_EQ(ends.size(), 2u);
  Obstacle ball;  // on the forearm as it comes to the goal from the start
  ball.shape = Solid::Shape::sphere;
  ball.radius = 0.01;
  const Solid forearm = place_links(robot, ends[0].q)[1].solids[0];
  ball.pose.translation() = forearm.pose * (0.5 * forearm.size);
  const SceneSensor sensor(robot, {"", {ball}});
  ASSERT_FALSE(sensor.position_free(ends[0].q));
  ASSERT_TRUE(sensor.position_free(ends[1].q));
  const Result r = plan(robot, sensor, request, Params("goritov2020"));
  EXPECT_EQ(r.status, Status::no_path) << r.error;
  EXPECT_EQ(r.fault, Fault::none);
  EXPECT_NE(r.error.find("try more postures"), std::string::npos) << r.error;
}

/// Stands anywhere, moves nowhere.
class Stuck final : public Sensor {
 public:
  bool position_free(const JointRef&) const override { return true; }
  bool motion_free(const JointRef&, const JointRef&) const override { return false; }
  double clearance() const override { return 0.001; }
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
    EXPECT_EQ(r.questions.positions + r.questions.motions, most);
  }
}

/// All is free but some positions.
class Without final : public Sensor {
 public:
  explicit Without(std::vector<End> ends) : ends_(std::move(ends)) {}
  bool position_free(const JointRef& q) const override {
    return std::ranges::none_of(ends_, [&](const End& end) { return end.q == q; });
  }
  bool motion_free(const JointRef&, const JointRef&) const override { return true; }
  double clearance() const override { return 0.001; }

 private:
  std::vector<End> ends_;
};

TEST(ArmPostures, MorePosturesAreLookedForWhereTheFirstAllTouch) {
  const Robot robot = shipped("redundant7");
  const JointVector start = JointVector::Constant(7, 0.3), there = JointVector::Constant(7, 0.7);
  const Request request{.start = start, .goals = {tip_position(robot, there)}};
  const std::array<int, 1> only{0};
  const auto first = find_ends(robot, Kinematics(robot), request, only, 1, 0, 64, 24);
  ASSERT_GT(first.size(), 4u);
  const Result r = plan(robot, Without(first), request);
  EXPECT_TRUE(r.direct) << r.error;
}

TEST(ArmPostures, AGoalOfJointValuesHasOnePosture) {
  const Robot robot = two_links();
  Obstacle ball;
  ball.shape = Solid::Shape::sphere;
  ball.radius = 0.05;
  const JointVector goal = joints({1, 0.5});
  ball.pose.translation() = tip_position(robot, goal);
  const Result r = plan(robot, SceneSensor(robot, {"", {ball}}),
                        {.start = joints({-1, 0.5}), .goals = {Goal::joints(goal)}});
  EXPECT_EQ(r.fault, Fault::goal_blocked);
  EXPECT_NE(r.error.find("in the only posture found"), std::string::npos) << r.error;
}

TEST(ArmPostures, GoalsThatCannotBeAreRefused) {
  const Robot robot = two_links();
  const auto error = [&](std::vector<Goal> goals) {
    const Result r = plan(robot, Nothing(), {.start = joints({0.3, 1}), .goals = std::move(goals)});
    EXPECT_EQ(r.status, Status::invalid);
    EXPECT_EQ(r.fault, Fault::goal_outside);
    return r.error;
  };
  EXPECT_EQ(error({}), "no goal is given");
  EXPECT_NE(error({Eigen::Vector3d(0.900001, 0, 0)}).find("it is 0.900001 m from"),
            std::string::npos);
  EXPECT_NE(error({Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(4, 0, 0)}).find("; goal 4,0,0"),
            std::string::npos);
  EXPECT_NE(error({Goal::joints(joints({1}))}).find("1 joint values"), std::string::npos);
  EXPECT_NE(error({Goal::joints(joints({1, 4}))}).find("joint 2 is 4"), std::string::npos);
  EXPECT_NE(error({Goal::pose(Pose::Identity(), 0, 1)}).find("tolerances"), std::string::npos);
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
