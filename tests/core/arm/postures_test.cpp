#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/arm/ends.h"
#include "tests/core/arm/questions.h"
#include "tests/core/base/refusal.h"

// What `postures` plans: goals of every kind, in whatever posture they are reached.
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

/// Postures that reach a request's first goal, `most` at most.
std::vector<End> ends_of_first_goal(const Robot& robot, const Request& request, int most) {
  const std::array<int, 1> only{0};
  return find_ends(robot, Kinematics(robot), request, only, 1, 0, 64, most);
}

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
        Params p = by_trees();
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

// Elbow up and elbow down: the source's one posture at the goal touches a ball, and is not reached.
TEST(ArmPostures, ChangesToThePostureThatIsFree) {
  const Robot robot = two_links();
  const JointVector start = joints({0.3, 1.2}), goal = joints({1, -1.2});
  // In the way of the forearm at the goal where the elbow is as at the start.
  const Eigen::Vector3d tip = tip_position(robot, goal);
  const double other = 2 * std::atan2(tip.y(), tip.x()) - goal[0];
  const Eigen::Vector3d elbow(0.5 * std::cos(other), 0.5 * std::sin(other), 0);
  const Scene scene{"", {ball(0.5 * (tip + elbow), 0.05)}};
  const SceneSensor sensor(robot, scene);
  const Request request{.start = start, .goals = {tip}};
  const Result source = plan(robot, sensor, request, Params("goritov2020"));
  EXPECT_NE(source.status, Status::solved);
  for (const bool direct : {true, false}) {
    Params p = by_trees();
    p.direct = direct;
    const Result r = plan(robot, sensor, request, p);
    ASSERT_EQ(r.status, Status::solved) << r.error;
    EXPECT_LT(largest_change(last(r), goal), 1e-5);
    EXPECT_EQ(recheck(robot, scene, r.trajectory).contacts, 0);
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
    Params p = by_trees();
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

TEST(ArmPostures, EveryPostureThatTouchesIsAFaultOfTheGoal) {
  const Robot robot = two_links();
  const Request request = across(robot);
  Obstacle there = ball(request.goals[0].target.translation(), 0.05);
  there.name = "ball";
  const Result r = plan(robot, SceneSensor(robot, {"", {there}}), request);
  EXPECT_EQ(r.status, Status::invalid);
  EXPECT_EQ(r.fault, Fault::goal_blocked);
  expect_says(r.error, "in each of 2 postures found");
}

TEST(ArmPostures, NoPosturesAreLookedForOnceToldToStop) {
  const Robot robot = two_links();
  std::stop_source source;
  Request request = across(robot);
  request.stop.token = source.get_token();
  const auto found = [&] { return ends_of_first_goal(robot, request, 8).size(); };
  EXPECT_EQ(found(), 2u);
  source.request_stop();
  EXPECT_EQ(found(), 0u);
}

TEST(ArmPostures, JointsAreTurnedByWholeTurnsTowardsTheStart) {
  Robot robot = two_links();
  for (Joint& joint : robot.joints) joint.low = -6, joint.high = 6;
  const Request request = across(robot);
  const auto ends = ends_of_first_goal(robot, request, 8);
  ASSERT_EQ(ends.size(), 2u) << "and none is told twice";
  for (const End& end : ends) EXPECT_LE(largest_change(end.q, request.start), 3.1416);
}

TEST(ArmPostures, AGoalIsNotBlockedWhereOneOfItsPosturesIs) {
  const Robot robot = two_links();
  const Request request = across(robot);
  const auto ends = ends_of_first_goal(robot, request, 8);
  ASSERT_EQ(ends.size(), 2u);
  // On the forearm as it comes to the goal from the start.
  const Solid forearm = place_links(robot, ends[0].q)[1].solids[0];
  const SceneSensor sensor(robot, {"", {ball(forearm.pose * (0.5 * forearm.size), 0.01)}});
  ASSERT_FALSE(sensor.position_free(ends[0].q));
  ASSERT_TRUE(sensor.position_free(ends[1].q));
  const Result r = plan(robot, sensor, request, Params("goritov2020"));
  EXPECT_EQ(r.status, Status::no_path) << r.error;
  EXPECT_EQ(r.fault, Fault::none);
  expect_says(r.error, "try the algorithm postures");
}

/// All is free but some positions.
class Without final : public Nothing {
 public:
  explicit Without(std::vector<End> ends) : ends_(std::move(ends)) {}
  bool position_free(const JointRef& q) const override {
    return std::ranges::none_of(ends_, [&](const End& end) { return end.q == q; });
  }

 private:
  std::vector<End> ends_;
};

TEST(ArmPostures, MorePosturesAreLookedForWhereTheFirstAllTouch) {
  const Robot robot = shipped("redundant7");
  const JointVector start = JointVector::Constant(7, 0.3), there = JointVector::Constant(7, 0.7);
  const Request request{.start = start, .goals = {tip_position(robot, there)}};
  const auto first = ends_of_first_goal(robot, request, 24);
  ASSERT_GT(first.size(), 4u);
  const Result r = plan(robot, Without(first), request);
  EXPECT_TRUE(r.direct) << r.error;
}

TEST(ArmPostures, AGoalOfJointValuesHasOnePosture) {
  const Robot robot = two_links();
  const JointVector goal = joints({1, 0.5});
  const Scene scene{"", {ball(tip_position(robot, goal), 0.05)}};
  const Result r = plan(robot, SceneSensor(robot, scene),
                        {.start = joints({-1, 0.5}), .goals = {Goal::joints(goal)}});
  EXPECT_EQ(r.fault, Fault::goal_blocked);
  expect_says(r.error, "in the only posture found");
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
  expect_says(error({Eigen::Vector3d(0.900001, 0, 0)}), "it is 0.900001 m from");
  expect_says(error({Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(4, 0, 0)}), "; goal 4,0,0");
  expect_says(error({Goal::joints(joints({1}))}), "1 joint values");
  expect_says(error({Goal::joints(joints({1, 4}))}), "joint 2 is 4");
  expect_says(error({Goal::pose(Pose::Identity(), 0, 1)}), "tolerances");
}

// By whole turns of a joint that turns freely, and of no other.
TEST(ArmPlan, EqualUpToTurnsIsThere) {
  Robot robot = two_links();
  for (Joint& joint : robot.joints) std::tie(joint.low, joint.high) = std::pair(-40, 40);
  robot.joints[0].continuous = true;
  const double turn = 2 * std::numbers::pi;
  for (const char* const algorithm : {"postures", "goritov2020"}) {
    for (const double turns : {-4., -1., 0., 1., 3.}) {
      const Result r = plan(robot, Nothing(),
                            {.start = joints({0.3 - turn, 1}),
                             .goals = {Goal::joints(joints({0.3 + (turns - 1) * turn, 1}))}},
                            Params(algorithm));
      EXPECT_EQ(r.status, Status::solved);
      EXPECT_EQ(std::tuple(r.length, r.joints.cols(), r.optimal), std::tuple(0., 1, true)) << turns;
    }
    const Result other =
        plan(robot, Nothing(),
             {.start = joints({0.3, 1}), .goals = {Goal::joints(joints({0.3, 1 - turn}))}},
             Params(algorithm));
    EXPECT_NE(other.length, 0);
  }
}

TEST(ArmPlan, AHairOutsideOfALimitIsTakenAtIt) {
  Robot robot = two_links();
  robot.joints[1].name = "elbow";
  const auto ask = [&](double start, double goal) {
    return plan(robot, Nothing(),
                {.start = joints({0, start}), .goals = {Goal::joints(joints({0.5, goal}))}});
  };
  using Notes = std::vector<std::string>;
  const Result at = ask(3.0009, -3.001);
  EXPECT_EQ(at.status, Status::solved);
  EXPECT_EQ(at.joints(1, 0), 3);
  EXPECT_EQ(last(at), joints({0.5, -3}));
  EXPECT_EQ(at.notes,
            (Notes{"start: joint 2 (elbow) is 3.0009, its limits are -3 .. 3: taken at the limit",
                   "goal: joint 2 (elbow) is -3.001, its limits are -3 .. 3: taken at the limit"}));
  EXPECT_EQ(ask(3, -3).notes, Notes{});
  EXPECT_EQ(ask(3.0011, 0).error, "start: joint 2 (elbow) is 3.0011, its limits are -3 .. 3");
  EXPECT_EQ(ask(0, 4).error, "goal: joint 2 (elbow) is 4, its limits are -3 .. 3");
}

}  // namespace
}  // namespace lasius::arm
