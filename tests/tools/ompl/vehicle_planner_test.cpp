// OMPL's questions answered by lasius, through OMPL's own interface.
#include "tools/ompl/vehicle_planner.h"

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include <cmath>

namespace lasius {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using State = ob::ScopedState<ob::SE2StateSpace>;

constexpr double kUnit = 0.05;  // of a cell

Grid room() {
  Grid grid(100, 60);
  grid.fill({50, 0, 2, 60}, true);
  grid.fill({50, 10, 2, 14}, false);
  return grid;
}

/// A problem in metres on a space of poses.
struct Question {
  explicit Question(const ob::StateSpacePtr& space) : setup(space) {
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0);
    bounds.setHigh(5);
    space->as<ob::SE2StateSpace>()->setBounds(bounds);
    setup.setStateValidityChecker([](const ob::State*) { return true; });
  }
  State state(double x, double y, double yaw) const {
    State state(setup.getStateSpace());
    state->setXY(x * kUnit, y * kUnit);
    state->setYaw(yaw);
    return state;
  }
  og::SimpleSetup setup;
};

void check(const Question& question, const Grid& grid, const vehicle::Vehicle& vehicle,
           const vehicle::Pose& start, const vehicle::Pose& goal) {
  const og::PathGeometric& path = const_cast<og::SimpleSetup&>(question.setup).getSolutionPath();
  std::vector<vehicle::Pose> poses;
  for (const ob::State* state : const_cast<og::PathGeometric&>(path).getStates()) {
    const auto* pose = state->as<ob::SE2StateSpace::StateType>();
    poses.push_back({pose->getX() / kUnit, pose->getY() / kUnit, pose->getYaw()});
  }
  ASSERT_GT(poses.size(), 10u);
  EXPECT_FALSE(vehicle::Space(grid, vehicle).first_contact(std::span<const vehicle::Pose>(poses)));
  for (const auto& [at, asked] : {std::pair(poses.front(), start), {poses.back(), goal}}) {
    EXPECT_NEAR(at.x, asked.x, 1e-6);
    EXPECT_NEAR(at.y, asked.y, 1e-6);
    EXPECT_NEAR(std::cos(at.yaw - asked.yaw), 1, 1e-9);
  }
}

TEST(OmplVehiclePlanner, AnswersOnTheSpacesOfPoses) {
  const Grid grid = room();
  const vehicle::Vehicle car = vehicle::car(vehicle::rectangle(2, 5, 2), 5);
  vehicle::Vehicle forward = car;
  forward.reverse = false;
  const std::pair<ob::StateSpacePtr, vehicle::Vehicle> all[] = {
      {std::make_shared<ob::ReedsSheppStateSpace>(5 * kUnit), car},
      {std::make_shared<ob::DubinsStateSpace>(5 * kUnit), forward},
      {std::make_shared<ob::SE2StateSpace>(), vehicle::differential(vehicle::rectangle(2, 5, 2))}};
  for (const auto& [space, vehicle] : all) {
    Question question(space);
    question.setup.setStartAndGoalStates(question.state(10, 50, 0), question.state(88, 45, 1));
    const auto planner = std::make_shared<OmplVehiclePlanner>(question.setup.getSpaceInformation(),
                                                              grid, vehicle, kUnit);
    question.setup.setPlanner(planner);
    ASSERT_EQ(question.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    check(question, grid, vehicle, {10, 50, 0}, {88, 45, 1});
    EXPECT_EQ(planner->result().status, Status::solved);
    // Once more from the beginning.
    question.setup.clear();
    EXPECT_TRUE(planner->result().segments.empty());
    EXPECT_TRUE(question.setup.solve(10.0));
  }
}

// The way leads through the gap, which is out of the space's bounds.
TEST(OmplVehiclePlanner, MovesNoPointIntoBounds) {
  const Grid grid = room();
  const vehicle::Vehicle car = vehicle::car(vehicle::rectangle(2, 5, 2), 5);
  const auto space = std::make_shared<ob::ReedsSheppStateSpace>(5 * kUnit);
  Question question(space);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(2.0);
  bounds.setHigh(5);
  bounds.setLow(0, 0.0);
  space->setBounds(bounds);
  question.setup.setStartAndGoalStates(question.state(10, 50, 0), question.state(88, 45, 1));
  question.setup.setPlanner(
      std::make_shared<OmplVehiclePlanner>(question.setup.getSpaceInformation(), grid, car, kUnit));
  ASSERT_EQ(question.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  check(question, grid, car, {10, 50, 0}, {88, 45, 1});
  for (const ob::State* state : question.setup.getSolutionPath().getStates()) {
    EXPECT_LE(std::fabs(state->as<ob::SE2StateSpace::StateType>()->getYaw()), 3.1415927);
  }
}

TEST(OmplVehiclePlanner, AnswersAgainWithoutClear) {
  const Grid grid = room();
  Question question(std::make_shared<ob::SE2StateSpace>());
  question.setup.setStartAndGoalStates(question.state(10, 50, 0), question.state(88, 45, 1));
  const auto planner = std::make_shared<OmplVehiclePlanner>(
      question.setup.getSpaceInformation(), grid,
      vehicle::differential(vehicle::rectangle(2, 5, 2)), kUnit);
  question.setup.setPlanner(planner);
  ASSERT_EQ(question.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  const std::vector<vehicle::Segment> first = planner->result().segments;
  for (int again = 0; again < 2; ++again) {
    ASSERT_EQ(question.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(planner->result().segments, first);
  }
}

TEST(OmplVehiclePlanner, OneOfSeveralGoals) {
  const Grid grid = room();
  const vehicle::Vehicle car = vehicle::car(vehicle::rectangle(2, 5, 2), 5);
  Question question(std::make_shared<ob::ReedsSheppStateSpace>(5 * kUnit));
  const auto goals = std::make_shared<ob::GoalStates>(question.setup.getSpaceInformation());
  goals->addState(question.state(88, 45, 1));
  goals->addState(question.state(30, 40, 0));
  question.setup.setStartState(question.state(10, 50, 0));
  question.setup.setGoal(goals);
  question.setup.setPlanner(
      std::make_shared<OmplVehiclePlanner>(question.setup.getSpaceInformation(), grid, car, kUnit));
  ASSERT_EQ(question.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  check(question, grid, car, {10, 50, 0}, {30, 40, 0});
}

TEST(OmplVehiclePlanner, SaysWhyThereIsNone) {
  const Grid grid = room();
  const vehicle::Vehicle car = vehicle::car(vehicle::rectangle(2, 5, 2), 5);
  const auto status = [&](double start, double goal, const ob::PlannerTerminationCondition& ends) {
    Question question(std::make_shared<ob::ReedsSheppStateSpace>(5 * kUnit));
    question.setup.setStartAndGoalStates(question.state(start, 50, 0), question.state(goal, 45, 1));
    question.setup.setPlanner(std::make_shared<OmplVehiclePlanner>(
        question.setup.getSpaceInformation(), grid, car, kUnit));
    return question.setup.solve(ends);
  };
  const auto never = ob::plannerNonTerminatingCondition();
  EXPECT_EQ(status(50, 88, never), ob::PlannerStatus::INVALID_START);
  EXPECT_EQ(status(10, 51, never), ob::PlannerStatus::INVALID_GOAL);
  EXPECT_EQ(status(10, 88, ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
  const auto flat =
      std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
  EXPECT_THROW(OmplVehiclePlanner(flat, grid, car), ompl::Exception);
}

}  // namespace
}  // namespace lasius
