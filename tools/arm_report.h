// Results of `lasius arm` as JSON, CSV and text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lasius/arm_plan.h"
#include "lasius/arm_trajectory.h"
#include "options.h"
#include "report.h"

namespace lasius::tool {

/// All that a run of `lasius arm` read and found.
struct ArmAnswer {
  arm::Robot robot;
  arm::Scene scene;
  std::uint64_t robot_hash = 0;  ///< of the files' bytes (FNV-1a)
  std::uint64_t scene_hash = 0;
  arm::Parameters parameters;
  double clearance = 0;
  arm::Result plan;
  arm::TrajectoryResult motion;
  std::optional<arm::Recheck> recheck;
  double elapsed_ms = 0;
};

/// Times at which a trajectory is told: every 1 / rate seconds, and its end.
std::vector<double> sample_times(const arm::Trajectory& trajectory, double rate);

Json arm_json(const ArmCommand& command, const ArmAnswer& answer);
std::string arm_text(const ArmAnswer& answer);
/// Header, and a row a sample: t, q1.., dq1.., ddq1.., x, y, z.
std::string arm_csv(const ArmCommand& command, const ArmAnswer& answer);

}  // namespace lasius::tool
