// One question to an arm answered, with all that a result records.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lasius/arm.h"
#include "lasius/base/error.h"
#include "tools/arm/arm_command.h"

namespace lasius::tool {

/// The values as the library takes them, not copied.
inline Eigen::Map<const arm::JointVector> joint_vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// A file that was read, and the hash of its bytes (FNV-1a).
using ReadFile = std::pair<std::string, std::uint64_t>;

/// Joint values that reach a goal.
struct Reaching {
  std::size_t goal;
  arm::JointVector q;
  arm::SceneSensor::Nearest nearest;
  bool free;
};

/// All that a run of `lasius arm` read and found.
struct ArmAnswer {
  arm::Robot robot;
  arm::Scene scene;
  arm::Scene held;  ///< in the tip's frame
  ReadFile robot_file, scene_file, held_file;
  std::vector<ReadFile> robot_files, scene_files,
      held_files;  ///< that these name, or that came with them
  arm::JointVector start;
  std::vector<arm::Goal> goals;
  arm::Params parameters;
  double clearance = 0;
  arm::Result plan;
  std::optional<arm::Recheck> recheck;
  double straight_reached = 0;                     ///< share of the line, of a straight motion
  std::vector<Reaching> inverse;                   ///< the nearest to the start first
  std::vector<arm::SceneSensor::Nearest> nearest;  ///< at the start, and at the motion's end
  double elapsed_ms = 0;
};

/// Where the tip is at a goal.
inline Eigen::Vector3d tip_of(const arm::Robot& robot, const arm::Goal& goal) {
  if (goal.kind == arm::Goal::Kind::joints) return arm::tip_position(robot, goal.values);
  return goal.target.translation();
}

/// Whether a call ended; its refusal of the question is the plan's error.
template <class Call>
bool answered(arm::Result& plan, const Call& call) {
  try {
    call();
    return true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_parameter) throw;
    plan.status = Status::invalid;
    plan.error = error.what();
    return false;
  }
}

/// The unit of a plan's length.
inline const char* unit_of(arm::Objective objective) {
  return objective == arm::Objective::duration ? "s at full speed"
         : objective == arm::Objective::joint  ? "rad"
                                               : "m";
}

}  // namespace lasius::tool
