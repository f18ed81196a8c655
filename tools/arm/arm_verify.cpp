#include "tools/arm/arm_verify.h"

#include "tools/arm/arm_answer.h"
#include "tools/arm/arm_report.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

ArmCommand recorded_command(const Json& result) {
  ArmCommand command;
  command.base_link = recorded_optional<std::string>(result, "robot/base_link").value_or("");
  command.tip_link = recorded_optional<std::string>(result, "robot/tip_link").value_or("");
  command.start = recorded<std::vector<double>>(result, "start");
  command.goal = recorded<std::array<double, 3>>(result, "goal");
  command.seed = recorded_seed(result);
  command.settings = recorded_parameters(result, arm::algorithms().front());
  command.clearance = recorded_real(result, "parameters/clearance", ArmCommand::kLeastClearance,
                                    ArmCommand::kMostClearance);
  command.target_gap = recorded<double>(result, "parameters/target_gap");
  command.time_limit = recorded_optional<double>(result, "parameters/time_limit");
  command.rate =
      recorded_real(result, "parameters/rate", ArmCommand::kLeastRate, ArmCommand::kMostRate);
  if (result.contains("recheck"))
    command.recheck =
        static_cast<int>(recorded_integer(result, "recheck/samples", 1, ArmCommand::kMostRecheck));
  return command;
}

}  // namespace

Json arm_replay(const Json& result, const std::string& robot, const std::string& scene, int threads,
                const std::stop_token& token) {
  ArmCommand command = recorded_command(result);
  command.robot = robot;
  command.scene = scene;
  command.threads = threads;
  ArmAnswer answer = prepare_arm(command);
  constexpr const char* kRemedy = "put the file of that time in its place";
  check_hash(robot, answer.robot_hash, recorded<std::string>(result, "robot/hash"), kRemedy);
  check_hash(scene, answer.scene_hash, recorded<std::string>(result, "scene/hash"), kRemedy);
  solve_arm(command, {.token = token}, {}, answer);
  return arm_json(command, answer);
}

}  // namespace lasius::tool
