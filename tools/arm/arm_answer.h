// One question to an arm answered, with all that a result records.
#pragma once

#include <cstdint>
#include <optional>

#include "lasius/arm_plan.h"
#include "lasius/arm_trajectory.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// All that a run of `lasius arm` read and found.
struct ArmAnswer {
  arm::Robot robot;
  arm::Scene scene;
  std::uint64_t robot_hash = 0;  ///< of the files' bytes (FNV-1a)
  std::uint64_t scene_hash = 0;
  arm::Params parameters;
  double clearance = 0;
  arm::Result plan;
  std::optional<arm::Recheck> recheck;
  double elapsed_ms = 0;
};

/// The values as the library takes them, not copied.
Eigen::Map<const arm::JointVector> joint_vector(const std::vector<double>& values);

/// Reads the robot and the scene. @throws Error for what is missing, broken or out of range;
/// UsageError where the start has not a value for each joint.
ArmAnswer prepare_arm(const ArmCommand& command);

/// Plans, the motion included.
void solve_arm(const ArmCommand& command, const StopCondition& stop, const arm::Observer& observer,
               ArmAnswer& answer);

}  // namespace lasius::tool
