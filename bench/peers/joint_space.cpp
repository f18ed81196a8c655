#include "bench/peers/joint_space.h"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <ctime>

#include "bench/peers/motions.h"

namespace lasius::peers {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using arm::JointVector;
using Space = ob::RealVectorStateSpace;
using Values = Eigen::Map<const JointVector>;
using Stopwatch = std::chrono::steady_clock;

constexpr double kAtGoal = 1e-6;  // metres
constexpr double kTurns = 7;      // of a joint without limits, radians to either side

double seconds_since(Stopwatch::time_point began) {
  return std::chrono::duration<double>(Stopwatch::now() - began).count();
}

// Checks that count.
class Counter {
 public:
  Counter(const JointChecks& checks, int joints) : checks_(&checks), joints_(joints) {}
  bool free(const ob::State* q) const {
    ++positions;
    return checks_->position(values(q));
  }
  bool free(const ob::State* from, const ob::State* to) const {
    ++motions;
    return checks_->motion(values(from), values(to));
  }
  Values values(const ob::State* q) const { return {q->as<Space::StateType>()->values, joints_}; }
  mutable std::int64_t positions = 0, motions = 0;

 private:
  const JointChecks* checks_;
  int joints_;
};

// All joint values with the tip at a position.
class TipGoal final : public ob::GoalSampleableRegion {
 public:
  TipGoal(const ob::SpaceInformationPtr& space, const arm::Robot& robot,
          const Eigen::Vector3d& position)
      : ob::GoalSampleableRegion(space),
        robot_(&robot),
        position_(position),
        bounds_(space->getStateSpace()->as<Space>()->getBounds()) {
    setThreshold(kAtGoal);
  }
  double distanceGoal(const ob::State* q) const override {
    return (arm::tip_position(*robot_, Values(q->as<Space::StateType>()->values, robot_->size())) -
            position_)
        .norm();
  }
  unsigned int maxSampleCount() const override { return 1000000; }
  // Where one attempt fails the planner finds the state outside its bounds, and asks again.
  void sampleGoal(ob::State* to) const override {
    const int n = robot_->size();
    JointVector q(n);
    for (int i = 0; i < n; ++i) q[i] = random_.uniformReal(bounds_.low[i], bounds_.high[i]);
    const bool found = reach(q);
    for (int i = 0; i < n; ++i)
      to->as<Space::StateType>()->values[i] = found ? q[i] : bounds_.high[i] + 1;
  }

 private:
  bool reach(JointVector& q) const {
    constexpr double kStep = 1e-6;
    const auto n = q.size();
    Eigen::MatrixXd slope(3, n);
    for (int i = 0; i < 60; ++i) {
      const Eigen::Vector3d tip = arm::tip_position(*robot_, q);
      const Eigen::Vector3d left = position_ - tip;
      if (left.norm() < 0.1 * kAtGoal) return true;
      for (Eigen::Index j = 0; j < n; ++j) {
        JointVector moved = q;
        moved[j] += kStep;
        slope.col(j) = (arm::tip_position(*robot_, moved) - tip) / kStep;
      }
      const Eigen::Matrix3d damped =
          slope * slope.transpose() + 1e-2 * left.squaredNorm() * Eigen::Matrix3d::Identity();
      const JointVector step = slope.transpose() * damped.ldlt().solve(left);
      for (Eigen::Index j = 0; j < n; ++j)
        q[j] = std::clamp(q[j] + std::clamp(step[j], -0.5, 0.5), bounds_.low[j], bounds_.high[j]);
    }
    return false;
  }

  const arm::Robot* robot_;
  Eigen::Vector3d position_;
  ob::RealVectorBounds bounds_;
  mutable ompl::RNG random_;
};

ob::RealVectorBounds bounds_of(const arm::Robot& robot, const JointVector& start) {
  ob::RealVectorBounds bounds(robot.size());
  for (int i = 0; i < robot.size(); ++i) {
    bounds.setLow(i, std::max(robot.joints[i].low, std::min(-kTurns, start[i])));
    bounds.setHigh(i, std::min(robot.joints[i].high, std::max(kTurns, start[i])));
  }
  return bounds;
}

// From `start` to the goal that `make_goal` makes; `seconds` reads a clock that began at 0, and
// `seconds_left(found)` says what there is for shortening.
template <class MakeGoal, class Seconds, class SecondsLeft>
JointTrial run(const arm::Robot& robot, const JointChecks& checks, const JointVector& start,
               const MakeGoal& make_goal, double cap_seconds, const Seconds& seconds,
               const SecondsLeft& seconds_left, std::uint32_t seed) {
  ompl::msg::noOutputHandler();  // it would print to stdout
  ompl::RNG::setSeed(seed);
  const auto space = std::make_shared<Space>(robot.size());
  space->setBounds(bounds_of(robot, start));
  const auto information = std::make_shared<ob::SpaceInformation>(space);
  const Counter counter(checks, robot.size());
  information->setStateValidityChecker(
      [&](const ob::State* q) { return space->satisfiesBounds(q) && counter.free(q); });
  const auto free = [&counter](const ob::State* a, const ob::State* b) {
    return counter.free(a, b);
  };
  information->setMotionValidator(std::make_shared<Motions<decltype(free)>>(information, free));
  information->setup();
  const auto problem = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<Space> from(space);
  std::copy(start.begin(), start.end(), from->values);
  problem->addStartState(from);
  problem->setGoal(make_goal(information));
  og::RRTConnect planner(information);
  planner.setProblemDefinition(problem);
  planner.setup();

  JointTrial trial;
  const double began = seconds();
  trial.solved = planner.ob::Planner::solve(cap_seconds) == ob::PlannerStatus::EXACT_SOLUTION;
  trial.seconds = seconds() - began;
  trial.positions = counter.positions;
  trial.motions = counter.motions;
  if (!trial.solved) return trial;
  og::PathGeometric path(*problem->getSolutionPath()->as<og::PathGeometric>());
  og::PathSimplifier(information, problem->getGoal())
      .simplify(path, seconds_left(trial.seconds), true);
  trial.shortened_travel = path.length();
  return trial;
}

}  // namespace

JointTrial run_rrt_connect(const arm::Robot& robot, const arm::Sensor& sensor,
                           const JointVector& start, const Eigen::Vector3d& goal,
                           double cap_seconds, double seconds_in_all, std::uint32_t seed) {
  const JointChecks checks{
      [&](const arm::JointRef& q) { return sensor.position_free(q); },
      [&](const arm::JointRef& a, const arm::JointRef& b) { return sensor.motion_free(a, b); }};
  const auto began = Stopwatch::now();
  return run(
      robot, checks, start,
      [&](const auto& space) { return std::make_shared<TipGoal>(space, robot, goal); }, cap_seconds,
      [&] { return seconds_since(began); },
      [&](double used) { return std::max(0.0, seconds_in_all - used); }, seed);
}

JointTrial run_rrt_connect(const arm::Robot& robot, const JointChecks& checks,
                           const JointVector& start, const JointVector& goal, double cap_seconds,
                           double more_seconds, std::uint32_t seed) {
  const auto at = [&](const ob::SpaceInformationPtr& space) {
    ob::ScopedState<Space> state(space);
    std::copy(goal.begin(), goal.end(), state->values);
    auto made = std::make_shared<ob::GoalState>(space);
    made->setState(state);
    return made;
  };
  return run(
      robot, checks, start, at, cap_seconds,
      [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; },
      [&](double) { return more_seconds; }, seed);
}

}  // namespace lasius::peers
