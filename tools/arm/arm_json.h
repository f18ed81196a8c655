// What a result of `lasius arm` says in JSON of its own: robot, goals, questions, motion.
#pragma once

#include "tools/arm/arm_answer.h"
#include "tools/record/problem.h"

namespace lasius::tool {

Json vector_json(const Eigen::Vector3d& p);
Json joint_values_json(const arm::JointRef& q);

/// Files by role, with hashes; of the robot also its joints, what its body is, and which pairs of
/// links are checked.
Json robot_json(const ArmCommand& command, const ArmAnswer& answer);
/// Of the scene, and of what is held.
Json scene_json(const ReadFile& file, const arm::Scene& scene, const std::vector<ReadFile>& files);

/// What was asked for, goal by goal.
Json goals_json(const ArmCommand& command, const ArmAnswer& answer);

/// Positions and motions so far, by iteration.
Json asked_json(const std::vector<arm::Questions>& asked);
/// In all, and these.
Json questions_json(const arm::Result& plan);

/// The motion as knots, and as samples, `rate` a second; null without one.
Json trajectory_json(const ArmAnswer& answer, double rate);

/// The question of a saved result. @throws UsageError for what is missing or no such value.
ArmCommand recorded_command(const Recorded& recorded);
/// Why a result of `postures` before 0.4.0 cannot be replayed; empty where it can.
std::string unlike_lattice(const Json& result);
/// Leaves out what arms had before 0.4.0, where it did nothing.
void forget_lattice(Json& result);

}  // namespace lasius::tool
