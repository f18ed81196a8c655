#include "arm_verify.h"

#include <nlohmann/json.hpp>

#include "arm_answer.h"
#include "arm_report.h"

namespace lasius::tool {
namespace {

ArmCommand recorded_command(const Json& recorded) {
  const Json& robot = recorded.at("robot");
  const Json& settings = recorded.at("parameters");
  ArmCommand command;
  if (robot.at("base_link").is_string())
    command.base_link = robot.at("base_link").get<std::string>();
  if (robot.at("tip_link").is_string()) command.tip_link = robot.at("tip_link").get<std::string>();
  command.start = recorded.at("start").get<std::vector<double>>();
  command.goal = recorded.at("goal").get<std::array<double, 3>>();
  command.seed = recorded.at("seed").get<std::uint64_t>();
  for (const auto& parameter : arm::algorithms().front().parameters) {
    const std::string name(parameter.name);
    command.settings.emplace_back(name, parameter_text(settings.at(name)));
  }
  command.clearance = settings.at("clearance").get<double>();
  command.target_gap = settings.at("target_gap").get<double>();
  if (!settings.at("time_limit").is_null())
    command.time_limit = settings.at("time_limit").get<double>();
  command.rate = settings.at("rate").get<double>();
  if (recorded.contains("recheck"))
    command.recheck = recorded.at("recheck").at("samples").get<int>();
  return command;
}

}  // namespace

Json arm_replay(const Json& recorded, const std::string& robot, const std::string& scene,
                int threads, const std::stop_token& token) {
  ArmCommand command = recorded_command(recorded);
  command.robot = robot;
  command.scene = scene;
  command.threads = threads;
  ArmAnswer answer = prepare_arm(command);
  constexpr const char* kRemedy = "put the file of that time in its place";
  check_hash(robot, answer.robot_hash, recorded.at("robot").at("hash").get<std::string>(), kRemedy);
  check_hash(scene, answer.scene_hash, recorded.at("scene").at("hash").get<std::string>(), kRemedy);
  solve_arm(command, {.token = token}, {}, answer);
  return arm_json(command, answer);
}

}  // namespace lasius::tool
