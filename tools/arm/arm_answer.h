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
  arm::TrajectoryResult motion;
  std::optional<arm::Recheck> recheck;
  double elapsed_ms = 0;
};

}  // namespace lasius::tool
