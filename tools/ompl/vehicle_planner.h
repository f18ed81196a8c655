// lasius as a planner of OMPL, for poses in the plane: SE2StateSpace, and of those that are such
// DubinsStateSpace and ReedsSheppStateSpace.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <chrono>
#include <memory>

#include "lasius/vehicle/planner.h"
#include "lasius/vehicle/stop_when.h"

namespace lasius {

/// Answers OMPL's questions by vehicle::Planner. What is free is what its map says: state validity
/// and motion checkers are not asked, nor are bounds. States are in cells and radians as
/// vehicle::Pose has them, times `unit` for each cell. Deterministic.
///
///     auto planner = std::make_shared<lasius::OmplVehiclePlanner>(si, grid, vehicle, 0.05);
///     setup.setPlanner(planner);
class OmplVehiclePlanner final : public ompl::base::Planner {
 public:
  static constexpr int kMostGoals = 16;  ///< that are taken of a region

  /// @param unit     of the states' coordinates: what a cell is long, above 0
  /// @param spacing  of the states of a path, cells
  /// @throws Error as vehicle::Planner; ompl::Exception for states that are no poses
  OmplVehiclePlanner(const ompl::base::SpaceInformationPtr& space, const Grid& grid,
                     const vehicle::Vehicle& vehicle, double unit = 1, double spacing = 0.5)
      : ompl::base::Planner(space, "lasius"),
        planner_(grid, vehicle),
        unit_(unit),
        spacing_(spacing) {
    if (std::dynamic_pointer_cast<ompl::base::SE2StateSpace>(space->getStateSpace()) == nullptr)
      throw ompl::Exception(getName(), "its states are poses: give an SE2StateSpace");
    specs_.recognizedGoal = ompl::base::GOAL_SAMPLEABLE_REGION;
    specs_.multithreaded = false;
    specs_.directed = true;
    specs_.provingSolutionNonExistence = false;
  }

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ends) override {
    using Answer = ompl::base::PlannerStatus;
    checkValidity();
    pis_.restart();  // each question is asked from its beginning
    vehicle::Request request;
    const ompl::base::State* const start = pis_.nextStart();
    if (start == nullptr) return Answer::INVALID_START;
    request.start = pose_of(start);
    while (static_cast<int>(request.goals.size()) < kMostGoals) {
      const ompl::base::State* const goal =
          request.goals.empty() ? pis_.nextGoal(ends) : pis_.nextGoal();
      if (goal == nullptr) break;
      request.goals.push_back(pose_of(goal));
    }
    if (request.goals.empty()) return Answer::INVALID_GOAL;
    request.bound = false;
    const vehicle::StopWhen stop([&ends] { return ends.eval(); });
    request.stop = stop.within(std::chrono::hours(24));
    result_ = planner_.plan(request);
    if (!result_.segments.empty()) {
      auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
      for (const vehicle::PathPose& at : vehicle::poses(result_.segments, spacing_))
        append(*path, at.pose);
      pdef_->addSolutionPath(path, false, 0.0, getName());
      return Answer::EXACT_SOLUTION;
    }
    if (result_.status == Status::invalid)
      return result_.fault == Fault::start_blocked || result_.fault == Fault::start_outside
                 ? Answer::INVALID_START
                 : Answer::INVALID_GOAL;
    return Answer::TIMEOUT;
  }
  void clear() override {
    Planner::clear();
    result_ = {};
  }

  /// Of the last question: segments, bounds, why there is no path; in cells.
  const vehicle::Result& result() const { return result_; }

 private:
  using Se2 = ompl::base::SE2StateSpace::StateType;
  vehicle::Pose pose_of(const ompl::base::State* state) const {
    const Se2* const pose = state->as<Se2>();
    return {pose->getX() / unit_, pose->getY() / unit_, pose->getYaw()};
  }
  void append(ompl::geometric::PathGeometric& path, const vehicle::Pose& pose) const {
    ompl::base::ScopedState<ompl::base::SE2StateSpace> state(si_->getStateSpace());
    state->setXY(pose.x * unit_, pose.y * unit_);
    state->setYaw(pose.yaw);
    // The yaw in one turn, and no more: a point that is moved into bounds is not on the path.
    const auto& space = *si_->getStateSpace()->as<ompl::base::SE2StateSpace>();
    space.getSubspace(1)->enforceBounds((*state)[1]);
    path.append(state.get());
  }

  vehicle::Planner planner_;
  double unit_, spacing_;
  vehicle::Result result_;
};

}  // namespace lasius
