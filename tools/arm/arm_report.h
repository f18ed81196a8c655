// Results of `lasius arm` as JSON, CSV and text.
#pragma once

#include <string>
#include <vector>

#include "tools/arm/arm_answer.h"
#include "tools/bitmap/report.h"

namespace lasius::tool {

/// What the independent check found, in a line.
std::string recheck_text(const arm::Recheck& recheck);

constexpr double kMostSamples = 1e6;

/// Samples a second of a trajectory: as many as wanted, kMostSamples in all at most.
double sample_rate(const arm::Trajectory& trajectory, double wanted);

/// Times at which a trajectory is told: so many a second, and its end.
std::vector<double> sample_times(const arm::Trajectory& trajectory, double wanted);

/// Format lasius-arm-plan/1, keys in the order of the contract.
Json arm_json(const ArmCommand& command, const ArmAnswer& answer);
/// Status, length and the tip's path in metres, one lattice point a line.
std::string arm_text(const ArmAnswer& answer);
/// Header, and a row a sample: t, q1.., dq1.., ddq1.., x, y, z.
std::string arm_csv(const ArmCommand& command, const ArmAnswer& answer);

}  // namespace lasius::tool
