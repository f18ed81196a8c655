// What is asked of an arm's tip beside a plan: straight motions, joint values, what is nearest.
#pragma once

#include <string>

#include "tools/arm/arm_answer.h"
#include "tools/record/problem.h"

namespace lasius::tool {

/// The answer's plan is the straight motion to the first goal that one goes to; its length that of
/// the line. Without one the plan says how far the line went that went furthest.
void plan_straight(const ArmCommand& command, const arm::SceneSensor& sensor,
                   const StopCondition& stop, ArmAnswer& answer);

/// "0.12 m between link 2 (after elbow) and obstacle 1 (shelf)".
std::string nearest_text(const arm::SceneSensor::Nearest& nearest);

/// "straight", "inverse" and "nearest", those of them that were asked for.
void add_tip_json(const ArmCommand& command, const ArmAnswer& answer, Json& json);

/// The reverse: what of these a saved result was asked for. @throws UsageError
void read_tip_options(const Json& result, ArmCommand& command);

}  // namespace lasius::tool
