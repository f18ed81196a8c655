// One question to an arm answered, with all that a result records.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lasius/arm.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// The values as the library takes them, not copied.
inline Eigen::Map<const arm::JointVector> joint_vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

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

}  // namespace lasius::tool
