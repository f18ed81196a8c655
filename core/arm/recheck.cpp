// A finished trajectory looked at once more.
#include <algorithm>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/frames.hpp>

#include "core/arm/robot/kinematics.h"
#include "core/arm/robot/vec3.h"
#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "lasius/arm/trajectory.h"

namespace lasius::arm {
namespace {

KDL::Vector vec(Vec3 v) { return {v.x, v.y, v.z}; }

KDL::Chain make_chain(const Robot& robot) {
  KDL::Chain chain;
  for (const Joint& joint : robot.joints) {
    const auto [r, origin] = from_eigen(joint.frame);
    const KDL::Rotation rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
    // A fixed segment to the joint's frame, then the joint itself.
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame(rotation, vec(origin))));
    const auto type =
        joint.kind == Joint::Kind::prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Vector::Zero(), vec(joint.axis), type)));
  }
  return chain;
}

Vec3 tip_by_kdl(const Robot& robot, const KDL::Chain& chain, const JointVector& q) {
  KDL::Frame at;
  for (int j = 0; j < robot.size(); ++j)
    at = at * chain.getSegment(2 * j).pose(0) * chain.getSegment(2 * j + 1).pose(q[j]);
  const KDL::Vector tip = at * vec(from_eigen(robot.tip).position);
  return {tip.x(), tip.y(), tip.z()};
}

bool breaks_limit(const Robot& robot, const Trajectory::State& state) {
  constexpr double kTolerance = 1e-9;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (state.q[j] < joint.low - kTolerance || state.q[j] > joint.high + kTolerance ||
        std::abs(state.dq[j]) > joint.velocity * (1 + kTolerance) ||
        std::abs(state.ddq[j]) > joint.acceleration * (1 + kTolerance)) {
      return true;
    }
  }
  return false;
}

/// Of the cubics between knots, all along; accelerations that jump have no jerk that holds. What a
/// change of acceleration by rounding makes of a short one does not count.
int broken_jerks(const Robot& robot, const Trajectory& trajectory) {
  constexpr double kTolerance = 1e-6, kRounding = 1e-9;
  const auto& knots = trajectory.knots();
  int broken = 0;
  const auto jumps = [&](const JointVector& from, const JointVector& to, double time) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const Joint& joint = robot.joints[j];
      if (joint.jerk > 0 && std::abs(to[j] - from[j]) > joint.jerk * time * (1 + kTolerance) +
                                                            kRounding * joint.acceleration)
        return true;
    }
    return false;
  };
  const JointVector rest = JointVector::Zero(robot.size());
  broken += jumps(rest, knots.front().ddq, 0);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    broken += jumps(knots[i].ddq, knots[i + 1].ddq, knots[i + 1].time - knots[i].time);
  return broken + jumps(knots.back().ddq, rest, 0);
}

void check(const Robot& robot, const Trajectory& trajectory, int samples) {
  if (trajectory.empty()) refuse("the trajectory is empty", "give it a knot");
  for (const Trajectory::Knot& knot : trajectory.knots()) {
    check_values(robot, as_span(knot.q));
    check_values(robot, as_span(knot.ddq), 1e300);
  }
  require_parameter(samples >= 1, "samples", samples, "it must be at least 1");
}

}  // namespace

Recheck recheck(const Robot& robot, const Scene& scene, const Trajectory& trajectory, int samples,
                const StopCondition& stop) {
  const SceneSensor sensor(robot, scene, Sensor::kLeastClearance);
  check(robot, trajectory, samples);
  const KDL::Chain chain = make_chain(robot);
  Poller poller(stop, 16);
  Recheck found{.limits = broken_jerks(robot, trajectory), .nearest = kInfinity};
  double last = 0, last_nearest = 0;
  for (int s = 0; s < samples; ++s, ++found.samples) {
    if (poller.stop_after(1)) break;
    const double share = samples > 1 ? static_cast<double>(s) / (samples - 1) : 0;
    const double time = share * trajectory.duration();
    const Trajectory::State state = trajectory.at(time);
    const Vec3 tip = tip_by_kdl(robot, chain, state.q);
    found.tip_error = std::max(found.tip_error, length(tip_position(robot, state.q) - tip));
    const double nearest = sensor.distance(state.q);
    found.nearest = std::min(found.nearest, nearest);
    found.contacts += nearest <= 0;
    found.limits += breaks_limit(robot, state);
    if (s > 0 && last_nearest > 0 && nearest > 0) {
      const auto free = sensor.try_curve(trajectory, last, time, stop);
      if (!free) break;
      found.unproven += !*free;
    }
    last = time;
    last_nearest = nearest;
  }
  return found;
}

}  // namespace lasius::arm
