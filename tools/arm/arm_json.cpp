#include "tools/arm/arm_json.h"

#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "lasius/arm/plan.h"
#include "tools/arm/arm_samples.h"
#include "tools/arm/arm_tip.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// Parameters of `postures` before 0.4.0.
constexpr std::array kGone{"postures", "lines", "leash", "vias", "refine", "prove", "scout"};

Json files_json(const std::vector<ReadFile>& files) {
  Json list = Json::array();
  for (const auto& [file, hash] : files)
    list.push_back({{"file", file}, {"hash", hash_text(hash)}});
  return list;
}

Json bodies_json(const arm::Robot& robot) {
  const auto joints = joint_names(robot);
  const auto links = link_names(robot);
  Json bodies = Json::array();
  for (const arm::Link& link : robot.links) {
    Json solids = Json::array();
    for (const arm::Solid& solid : link.solids) solids.push_back(to_string(solid.shape));
    bodies.push_back({{"name", links[bodies.size()]},
                      {"moves_with", link.body == 0 ? Json(nullptr) : Json(joints[link.body - 1])},
                      {"solids", std::move(solids)}});
  }
  return bodies;
}

/// "pairs_checked", and "pairs_not_checked" with the reason.
void add_pairs(Json& json, const arm::Robot& robot) {
  const auto links = link_names(robot);
  Json checked = Json::array(), others = Json::array();
  for (const arm::LinkPair& pair : arm::link_pairs(robot)) {
    Json names = {links[pair.first], links[pair.second]};
    if (pair.check == arm::LinkPair::Check::yes)
      checked.push_back(std::move(names));
    else
      others.push_back({{"links", std::move(names)}, {"why", to_string(pair.check)}});
  }
  json["pairs_checked"] = std::move(checked);
  json["pairs_not_checked"] = std::move(others);
}

/// The reverse of goals_json, of a result. @throws UsageError
std::vector<ArmGoal> recorded_goals(const Json& result) {
  std::vector<ArmGoal> goals;
  for (const Json& goal : recorded<std::vector<Json>>(result, "goals")) {
    const auto kind = static_cast<ArmGoal::Kind>(
        choice_value("\"goals/kind\"", recorded<std::string>(goal, "kind"), kGoalKinds));
    goals.push_back({kind, recorded<std::vector<double>>(goal, "values"),
                     goal.contains("state") ? recorded<std::string>(goal, "state") : ""});
    const std::size_t count = goals.back().values.size();
    if (kind != ArmGoal::Kind::joints && count != (kind == ArmGoal::Kind::pose ? 6 : 3))
      throw UsageError("\"goals/values\" is " + dumped(goal["values"]));
  }
  if (goals.empty()) throw UsageError("\"goals\" is []");
  return goals;
}

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

Json vector_json(const Eigen::Vector3d& p) { return {number(p.x()), number(p.y()), number(p.z())}; }

Json joint_values_json(const arm::JointRef& q) {
  return numbers(std::vector<double>(q.begin(), q.end()));
}

Json robot_json(const ArmCommand& command, const ArmAnswer& answer) {
  const arm::Robot& robot = answer.robot;
  Json packages = Json::object();
  for (const auto& [name, folder] : command.packages) packages[name] = folder;
  Json json = {{"file", command.robot},
               {"hash", hash_text(answer.robot_file.second)},
               {"base_link", text_or_null(command.base_link)},
               {"tip_link", text_or_null(command.tip_link)},
               {"name", robot.name},
               {"joints", robot.size()},
               {"joint_names", joint_names(robot)},
               {"srdf", text_or_null(command.srdf)},
               {"joint_limits", text_or_null(command.joint_limits)},
               {"packages", std::move(packages)},
               {"files", files_json(answer.robot_files)},
               {"notes", robot.notes},
               {"warnings", robot.warnings},
               {"bodies", bodies_json(robot)}};
  add_pairs(json, robot);
  return json;
}

Json scene_json(const ReadFile& file, const arm::Scene& scene, const std::vector<ReadFile>& files) {
  return {{"file", file.first},         {"hash", hash_text(file.second)},
          {"name", scene.name},         {"obstacles", scene.obstacles.size()},
          {"warnings", scene.warnings}, {"files", files_json(files)}};
}

Json goals_json(const ArmCommand& command, const ArmAnswer& answer) {
  Json goals = Json::array();
  for (std::size_t i = 0; i < command.goals.size(); ++i) {
    const ArmGoal& goal = command.goals[i];
    Json json = {{"kind", kGoalKinds[static_cast<std::size_t>(goal.kind)]}};
    if (!goal.state.empty()) json["state"] = goal.state;
    json["values"] = goal.kind == ArmGoal::Kind::joints ? joint_values_json(answer.goals[i].values)
                                                        : numbers(goal.values);
    if (goal.kind == ArmGoal::Kind::pose) {
      json["position_tolerance"] = number(command.position_tolerance);
      json["angle_tolerance"] = number(command.angle_tolerance);
    }
    goals.push_back(std::move(json));
  }
  return goals;
}

Json asked_json(const std::vector<arm::Questions>& asked) {
  Json positions = Json::array(), motions = Json::array();
  for (const arm::Questions& so_far : asked) {
    positions.push_back(so_far.positions);
    motions.push_back(so_far.motions);
  }
  return {{"positions", std::move(positions)}, {"motions", std::move(motions)}};
}

Json questions_json(const arm::Result& plan) {
  return {{"positions", plan.questions.positions},
          {"motions", plan.questions.motions},
          {"trajectory", plan.questions.trajectory},
          {"by_iteration", asked_json(plan.asked)}};
}

Json trajectory_json(const ArmAnswer& answer, double rate) {
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  if (trajectory.empty()) return nullptr;
  Json knots = {{"t", Json::array()}, {"q", Json::array()}, {"ddq", Json::array()}};
  for (const auto& knot : trajectory.knots()) {
    knots["t"].push_back(number(knot.time));
    knots["q"].push_back(joint_values_json(knot.q));
    knots["ddq"].push_back(joint_values_json(knot.ddq));
  }
  Json samples = {{"t", Json::array()},
                  {"q", Json::array()},
                  {"dq", Json::array()},
                  {"ddq", Json::array()},
                  {"tip", Json::array()}};
  for (const double t : sample_times(trajectory, rate)) {
    const auto state = trajectory.at(t);
    samples["t"].push_back(number(t));
    samples["q"].push_back(joint_values_json(state.q));
    samples["dq"].push_back(joint_values_json(state.dq));
    samples["ddq"].push_back(joint_values_json(state.ddq));
    samples["tip"].push_back(vector_json(arm::tip_position(answer.robot, state.q)));
  }
  return {{"duration", number(trajectory.duration())},
          {"waypoints", answer.plan.waypoints},
          {"stops", answer.plan.stops},
          {"knots", knots},
          {"samples", samples}};
}

std::string unlike_lattice(const Json& result) {
  if (value_at(result, "iterations") == 0) return {};
  const Json& given = value_at(result, "parameters");
  for (const char* gone : kGone) {
    const Json idle = gone == kGone[0] ? 1 : 0;
    if (given.contains(gone) && given[gone] != idle && given[gone] != "off")
      return std::string("it was sought in a lattice with the parameter ") + gone +
             ", which is gone; plan it anew, or verify it with the version that wrote it";
  }
  return {};
}

void forget_lattice(Json& result) {
  for (const char* gone : kGone) result["parameters"].erase(gone);
  if (const auto lattice = result.find("lattice"); lattice != result.end() && lattice->is_object())
    lattice->erase("postures");
}

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
  if (result.contains("held")) {
    command.held = from.found(recorded<std::string>(result, "held/file"));
    command.held_touches = recorded<std::vector<std::string>>(result, "held/may_touch");
  }
  read_tip_options(result, command);
  read_goals(result, command);
  read_robot(from, command);
  return command;
}

}  // namespace lasius::tool
