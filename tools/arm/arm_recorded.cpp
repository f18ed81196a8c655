#include "tools/arm/arm_recorded.h"

#include <map>
#include <nlohmann/json.hpp>

#include "lasius/arm_plan.h"
#include "tools/arm/arm_json.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

void read_robot(const Recorded& from, ArmCommand& command) {
  const Json& result = from.result;
  const auto file = [&](const std::string& key) {
    const auto name = recorded_optional<std::string>(result, key);
    return name ? from.found(*name) : std::string();
  };
  command.srdf = file("robot/srdf");
  command.joint_limits = file("robot/joint_limits");
  command.packages = recorded<std::map<std::string, std::string>>(result, "robot/packages");
  for (auto& [name, folder] : command.packages) folder = from.found(folder);
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  command.contacts = recorded<Pairs>(result, "parameters/allow_contact");
  command.joint_values = recorded<std::map<std::string, double>>(result, "parameters/set_joint");
  command.visual = recorded<bool>(result, "parameters/use_visual");
  command.bodiless = recorded<bool>(result, "parameters/bodiless");
}

void read_goals(const Json& result, ArmCommand& command) {
  command.start_state = recorded_optional<std::string>(result, "start_state").value_or("");
  command.goals = recorded_goals(result);
  for (const Json& goal : result["goals"]) {
    if (!goal.contains("position_tolerance")) continue;
    const auto tolerance = [&](const char* key) {
      return recorded_real(goal, key, ArmCommand::kLeastTolerance, ArmCommand::kMostTolerance);
    };
    command.position_tolerance = tolerance("position_tolerance");
    command.angle_tolerance = tolerance("angle_tolerance");
  }
}

}  // namespace

ArmCommand recorded_command(const Recorded& from) {
  const Algorithm& algorithm = arm::find_algorithm(recorded<std::string>(from.result, "algorithm"));
  const Json& result = from.result;
  ArmCommand command;
  read_recorded(from, algorithm, command);
  command.robot = from.found(recorded<std::string>(result, "robot/file"));
  command.scene = from.found(recorded<std::string>(result, "scene/file"));
  command.base_link = recorded_optional<std::string>(result, "robot/base_link").value_or("");
  command.tip_link = recorded_optional<std::string>(result, "robot/tip_link").value_or("");
  command.start = recorded<std::vector<double>>(result, "start");
  command.clearance = recorded_real(result, "parameters/clearance", ArmCommand::kLeastClearance,
                                    ArmCommand::kMostClearance);
  command.rate =
      recorded_real(result, "parameters/rate", ArmCommand::kLeastRate, ArmCommand::kMostRate);
  if (!value_at(result, "parameters/duration").is_null())
    command.duration = recorded_real(result, "parameters/duration", ArmCommand::kLeastDuration,
                                     ArmCommand::kMostDuration);
  if (result.contains("recheck"))
    command.recheck =
        static_cast<int>(recorded_integer(result, "recheck/samples", 1, ArmCommand::kMostRecheck));
  read_goals(result, command);
  read_robot(from, command);
  return command;
}

}  // namespace lasius::tool
