#include "tools/arm/arm_json.h"

#include <array>
#include <nlohmann/json.hpp>

#include "tools/arm/arm_samples.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

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

Json scene_json(const ArmCommand& command, const ArmAnswer& answer) {
  return {{"file", command.scene},
          {"hash", hash_text(answer.scene_file.second)},
          {"name", answer.scene.name},
          {"obstacles", answer.scene.obstacles.size()},
          {"warnings", answer.scene.warnings},
          {"files", files_json(answer.scene_files)}};
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

}  // namespace lasius::tool
