#include "core/arm/robot/urdf_joints.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/arm/robot/refusals.h"
#include "core/arm/robot/urdf_geometry.h"
#include "core/base/number_text.h"

namespace lasius::arm {

namespace {

constexpr double kLargestLimit = 1000;  // of a limit, radians or metres: what `validate` takes

}  // namespace

bool moves(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS ||
         joint.type == urdf::Joint::PRISMATIC;
}

std::pair<double, double> range_of(const urdf::Joint& joint, const JointLimitsFile& limits) {
  const bool continuous = joint.type == urdf::Joint::CONTINUOUS;
  double low = continuous ? -kLargestLimit : 0, high = continuous ? kLargestLimit : 0;
  if (!continuous && joint.limits != nullptr) {
    low = joint.limits->lower;
    high = joint.limits->upper;
  }
  // Where only a gain is given, urdfdom takes both soft limits for 0.
  if (const auto& safety = joint.safety;
      safety != nullptr && (safety->soft_lower_limit != 0 || safety->soft_upper_limit != 0)) {
    low = std::max(low, safety->soft_lower_limit);
    high = std::min(high, safety->soft_upper_limit);
  }
  if (const auto limit = limits.joints.find(joint.name); limit != limits.joints.end()) {
    low = std::fmax(low, limit->second.low);
    high = std::fmin(high, limit->second.high);
  }
  return {low, high};
}

Joint moving_joint(const urdf::Joint& joint, const Placement& at, const UrdfFile& source,
                   const JointLimitsFile& limits, std::vector<std::string>& notes) {
  Joint made;
  made.name = joint.name;
  made.frame = to_eigen(at);
  const Vec3 axis = vec(joint.axis);
  if (!(length(axis) > 1e-9))
    broken(source.joint(joint.name), "joint \"" + joint.name + "\" has an axis of no length",
           "as in xyz=\"0 0 1\"");
  made.axis = (1 / length(axis)) * axis;
  made.kind = joint.type == urdf::Joint::PRISMATIC ? Joint::Kind::prismatic : Joint::Kind::revolute;
  std::tie(made.low, made.high) = range_of(joint, limits);
  made.continuous = joint.type == urdf::Joint::CONTINUOUS && made.low == -kLargestLimit &&
                    made.high == kLargestLimit;
  if (!(made.low < made.high))
    broken(source.joint(joint.name),
           "joint \"" + joint.name + "\" has limits that leave it no room",
           "give it a <limit> with lower below upper, and soft limits within");
  if (made.low < -kLargestLimit || made.high > kLargestLimit)
    broken(source.joint(joint.name),
           "joint \"" + joint.name + "\" has limits beyond " + number_text(kLargestLimit),
           "give it a <limit> within, or take it for continuous");
  const auto limit = limits.joints.find(joint.name);
  const bool listed = limit != limits.joints.end();
  const bool given = listed && !std::isnan(limit->second.velocity);
  if (given) {
    made.velocity = limit->second.velocity;
  } else if (joint.limits == nullptr) {
    made.velocity = limits.velocity;
    notes.push_back("joint " + in_quotes(joint.name) +
                    " has no velocity limit: " + number_text(made.velocity) + " a second is taken");
  } else {
    made.velocity = limits.velocity * joint.limits->velocity;
  }
  if (!(made.velocity > 0))
    broken(source.joint(joint.name),
           "joint \"" + joint.name + "\" has the velocity limit " + number_text(made.velocity),
           "give it one above 0 here or in a joint_limits.yaml");
  made.acceleration = limits.acceleration * 4 * made.velocity;
  if (listed && !std::isnan(limit->second.acceleration))
    made.acceleration = limit->second.acceleration;
  if (listed && !std::isnan(limit->second.jerk)) made.jerk = limit->second.jerk;
  return made;
}

}  // namespace lasius::arm
