#include "tools/arm/arm_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lasius/version.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json point(const Eigen::Vector3d& p) { return {number(p.x()), number(p.y()), number(p.z())}; }

Json joint_values(const arm::JointRef& q) {
  return numbers(std::vector<double>(q.begin(), q.end()));
}

Json settings_json(const ArmCommand& command, const ArmAnswer& answer) {
  Json object = parameters_json(arm::algorithms().front(), [&](std::string_view name) {
    return get_parameter(answer.parameters, name);
  });
  object["clearance"] = number(answer.clearance);
  object["target_gap"] = number(command.target_gap);
  object["time_limit"] = optional_number(command.time_limit);
  object["rate"] = number(command.rate);
  return object;
}

Json trajectory_json(const ArmCommand& command, const ArmAnswer& answer) {
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  if (trajectory.empty()) return nullptr;
  Json knots = {{"t", Json::array()}, {"q", Json::array()}, {"ddq", Json::array()}};
  for (const auto& knot : trajectory.knots()) {
    knots["t"].push_back(number(knot.time));
    knots["q"].push_back(joint_values(knot.q));
    knots["ddq"].push_back(joint_values(knot.ddq));
  }
  Json samples = {{"t", Json::array()},
                  {"q", Json::array()},
                  {"dq", Json::array()},
                  {"ddq", Json::array()},
                  {"tip", Json::array()}};
  for (const double t : sample_times(trajectory, command.rate)) {
    const auto state = trajectory.at(t);
    samples["t"].push_back(number(t));
    samples["q"].push_back(joint_values(state.q));
    samples["dq"].push_back(joint_values(state.dq));
    samples["ddq"].push_back(joint_values(state.ddq));
    samples["tip"].push_back(point(arm::tip_position(answer.robot, state.q)));
  }
  return {{"duration", number(trajectory.duration())},
          {"waypoints", answer.plan.waypoints},
          {"stops", answer.plan.stops},
          {"knots", knots},
          {"samples", samples}};
}

}  // namespace

double sample_rate(const arm::Trajectory& trajectory, double wanted) {
  return trajectory.duration() * wanted <= kMostSamples ? wanted
                                                        : kMostSamples / trajectory.duration();
}

std::vector<double> sample_times(const arm::Trajectory& trajectory, double wanted) {
  const double rate = sample_rate(trajectory, wanted);
  const double count = std::floor(trajectory.duration() * rate);
  std::vector<double> times;
  for (double i = 0; i <= count; ++i) times.push_back(std::min(i / rate, trajectory.duration()));
  if (times.back() < trajectory.duration()) times.push_back(trajectory.duration());
  return times;
}

Json arm_json(const ArmCommand& command, const ArmAnswer& answer) {
  const arm::Result& plan = answer.plan;
  Json json = Json::object();
  json["format"] = kArmFormat;
  json["version"] = LASIUS_VERSION;
  json["robot"] = {{"file", command.robot},
                   {"hash", hash_text(answer.robot_hash)},
                   {"base_link", text_or_null(command.base_link)},
                   {"tip_link", text_or_null(command.tip_link)},
                   {"name", answer.robot.name},
                   {"joints", answer.robot.size()}};
  json["scene"] = {{"file", command.scene},
                   {"hash", hash_text(answer.scene_hash)},
                   {"name", answer.scene.name},
                   {"obstacles", answer.scene.obstacles.size()}};
  json["algorithm"] = arm::algorithms().front().name;
  json["start"] = numbers(command.start);
  json["goal"] = numbers({command.goal.begin(), command.goal.end()});
  json["seed"] = command.seed;
  json["threads"] = command.threads;
  json["parameters"] = settings_json(command, answer);
  json["status"] = to_string(plan.status);
  json["error"] = text_or_null(plan.error);
  json["length"] = number(plan.length);
  json["path"] = nullptr;
  json["joints"] = nullptr;
  if (plan.tips.cols() > 0) {
    json["path"] = Json::array();
    for (const auto tip : plan.tips.colwise()) json["path"].push_back(point(tip));
    json["joints"] = Json::array();
    for (const auto q : plan.joints.colwise()) json["joints"].push_back(joint_values(q));
  }
  json["lattice"] = {{"pitch", number(plan.pitch)}, {"points", plan.points}};
  json["iterations"] = plan.iterations;
  json["best"] = numbers(plan.best);
  json["mean"] = numbers(plan.mean);
  json["arrived"] = plan.arrived;
  json["questions"] = {{"positions", plan.questions.positions},
                       {"motions", plan.questions.motions},
                       {"trajectory", answer.plan.questions.trajectory}};
  json["lower_bound"] = optional_number(plan.lower_bound);
  json["gap"] = optional_number(plan.gap());
  json["optimal"] = plan.optimal;
  json["trajectory"] = trajectory_json(command, answer);
  if (answer.recheck) {
    json["recheck"] = {{"samples", answer.recheck->samples},
                       {"contacts", answer.recheck->contacts},
                       {"limits", answer.recheck->limits},
                       {"nearest", number(answer.recheck->nearest)},
                       {"tip_error", number(answer.recheck->tip_error)}};
  }
  json["elapsed_ms"] = number(answer.elapsed_ms);
  return json;
}

std::string recheck_text(const arm::Recheck& recheck) {
  return "recheck: " + counted(recheck.samples, "sample") + ", " +
         counted(recheck.contacts, "contact") + ", " + counted(recheck.limits, "broken limit") +
         ", nearest " + to_text(recheck.nearest) + " m";
}

std::string arm_text(const ArmAnswer& answer) {
  const arm::Result& plan = answer.plan;
  std::ostringstream out;
  out << to_string(plan.status) << "\n";
  if (plan.tips.cols() == 0) return out.str();
  out << to_text(plan.length) << "\n";
  for (const auto tip : plan.tips.colwise())
    out << to_text(tip.x()) << " " << to_text(tip.y()) << " " << to_text(tip.z()) << "\n";
  return out.str();
}

std::string arm_csv(const ArmCommand& command, const ArmAnswer& answer) {
  std::ostringstream out;
  out << "t";
  for (const char* name : {"q", "dq", "ddq"})
    for (int j = 1; j <= answer.robot.size(); ++j) out << "," << name << j;
  out << ",x,y,z\n";
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  if (trajectory.empty()) return out.str();
  for (const double t : sample_times(trajectory, command.rate)) {
    const auto state = trajectory.at(t);
    out << to_text(t);
    for (const auto* values : {&state.q, &state.dq, &state.ddq})
      for (const double value : *values) out << "," << to_text(value);
    const Eigen::Vector3d tip = arm::tip_position(answer.robot, state.q);
    out << "," << to_text(tip.x()) << "," << to_text(tip.y()) << "," << to_text(tip.z()) << "\n";
  }
  return out.str();
}

}  // namespace lasius::tool
