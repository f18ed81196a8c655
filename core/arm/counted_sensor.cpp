#include "core/arm/counted_sensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/plan_check.h"
#include "core/arm/robot/kinematics.h"
#include "core/base/invalid_parameter.h"
#include "core/loop/run_status.h"

namespace lasius::arm {
namespace {

/// A bound for how far any point of the arm moves when joint j turns by one radian.
std::vector<double> levers(const Robot& robot) {
  std::vector<double> most(robot.joints.size(), 0);
  for (int body = 1; body <= robot.size(); ++body) {
    double far = body == robot.size() ? length(from_eigen(robot.tip).position) : 0;
    far = std::max(far, extent(robot, body));
    const auto lever = levers_of(robot, body, far);
    for (int j = 0; j < body; ++j) most[j] = std::max(most[j], lever[j]);
  }
  return most;
}

}  // namespace

void check_clearance(const Sensor& sensor) {
  const double clearance = sensor.clearance();
  require_parameter(clearance >= Sensor::kLeastClearance, "the sensor's clearance", clearance,
                    "it must be at least 0.000001 metres");
}

CountedSensor::CountedSensor(const Robot& robot, const Sensor& sensor,
                             const TrajectoryOptions& options)
    : robot_(robot),
      sensor_(sensor),
      clearance_(sensor.clearance()),
      stop_(options.stop),
      poller_(stop_, kQuestions),
      most_(options.max_questions) {
  check_clearance(sensor);
}

bool CountedSensor::may_ask() {
  if (poller_.stop_after(1) || (spent_ |= asked_ >= most_)) return false;
  ++asked_;
  return true;
}

bool CountedSensor::told(std::optional<bool> free) {
  if (!free) poller_.stop_after(kQuestions);
  return free.value_or(false);
}

bool CountedSensor::motion_free(const JointRef& from, const JointRef& to) {
  return may_ask() && told(sensor_.try_motion(from, to, stop_));
}

bool CountedSensor::curve_free(const Trajectory& trajectory, double from, double to) {
  if (knows_curves_) {
    if (!may_ask()) return false;
    const auto free = sensor_.try_curve(trajectory, from, to, stop_);
    if (free || poller_.stop_after(kQuestions)) return free.value_or(false);
    --asked_;
    knows_curves_ = false;
  }
  return chords_free(trajectory, from, to);
}

/// A chord over a time h is within h^2 / 8 max |ddq| of the joint's curve.
bool CountedSensor::chords_free(const Trajectory& trajectory, double from, double to) {
  if (levers_.empty()) levers_ = levers(robot_);
  JointVector most = JointVector::Zero(robot_.size());
  const auto& knots = trajectory.knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (knots[i + 1].time <= from || knots[i].time >= to) continue;
    most = most.cwiseMax(knots[i].ddq.cwiseAbs()).cwiseMax(knots[i + 1].ddq.cwiseAbs());
  }
  const double h = to - from;
  double bend = 0;
  for (int j = 0; j < robot_.size(); ++j) bend += levers_[j] * most[j];
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(h * std::sqrt(bend / (8 * clearance_)))));
  JointVector here = trajectory.at(from).q;
  for (int p = 1; p <= pieces; ++p) {
    JointVector there = trajectory.at(p == pieces ? to : from + h * p / pieces).q;
    if (!motion_free(here, there)) return false;
    here = std::move(there);
  }
  return true;
}

void CountedSensor::finish(TrajectoryResult& result) const {
  end_run(result, poller_.cause(), spent_ ? Status::limit : Status::solved);
  if (spent_ && !poller_.stopped()) result.limit = Limit::questions;
  result.questions = asked_;
}

}  // namespace lasius::arm
