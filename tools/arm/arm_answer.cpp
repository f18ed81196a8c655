#include "tools/arm/arm_answer.h"

#include <fstream>

#include "lasius/arm_sensor.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// FNV-1a of a file that was just read.
std::uint64_t file_hash(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (char c = 0; in.get(c);) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

}  // namespace

Eigen::Map<const arm::JointVector> joint_vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

ArmAnswer prepare_arm(const ArmCommand& command) {
  ArmAnswer answer;
  for (const auto& [name, value] : command.settings)
    arm::set_parameter(answer.parameters, name, value);
  answer.parameters.seed = command.seed;
  answer.parameters.threads = command.threads;
  arm::validate(answer.parameters);
  answer.robot =
      arm::read_robot(command.robot, {.base = command.base_link, .tip = command.tip_link});
  answer.robot_hash = file_hash(command.robot);
  if (static_cast<int>(command.start.size()) != answer.robot.size())
    throw UsageError("--start gives " +
                     counted(static_cast<std::int64_t>(command.start.size()), "joint value") +
                     ", " + command.robot + " has " + counted(answer.robot.size(), "joint"));
  answer.scene = arm::read_scene(command.scene);
  answer.scene_hash = file_hash(command.scene);
  answer.clearance = command.clearance > 0 ? command.clearance : arm::SceneSensor::kClearance;
  return answer;
}

void solve_arm(const ArmCommand& command, const StopCondition& stop, const arm::Observer& observer,
               ArmAnswer& answer) {
  const arm::SceneSensor sensor(answer.robot, answer.scene, answer.clearance);
  const auto begin = Clock::now();
  const arm::Request request{.start = joint_vector(command.start),
                             .goal = {command.goal[0], command.goal[1], command.goal[2]},
                             .stop = stop,
                             .target_gap = command.target_gap};
  answer.plan = arm::plan(answer.robot, sensor, request, answer.parameters, observer);
  answer.elapsed_ms = ms_since(begin);
  if (command.recheck > 0 && !answer.plan.trajectory.empty())
    answer.recheck =
        arm::recheck(answer.robot, answer.scene, answer.plan.trajectory, command.recheck);
}

}  // namespace lasius::tool
