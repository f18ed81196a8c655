#include "tools/arm/arm_tip.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lasius/arm_plan.h"
#include "lasius/error.h"
#include "tools/arm/arm_json.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// The line as an answer; it has a motion.
arm::Result result_of(const arm::Robot& robot, const arm::TipLine& line, int goal) {
  arm::Result plan;
  plan.joints = line.joints;
  plan.tips.resize(3, line.joints.cols());
  for (Eigen::Index i = 0; i < line.joints.cols(); ++i) {
    plan.tips.col(i) = arm::tip_position(robot, line.joints.col(i));
    if (i == 0) continue;
    plan.joint_travel += (line.joints.col(i) - line.joints.col(i - 1)).norm();
    plan.tip_travel += (plan.tips.col(i) - plan.tips.col(i - 1)).norm();
  }
  plan.length = (plan.tips.rightCols<1>() - plan.tips.leftCols<1>()).norm();
  plan.goal = goal;
  plan.trajectory = line.trajectory;
  plan.duration = line.trajectory.duration();
  plan.waypoints = static_cast<int>(line.joints.cols());
  plan.stops = line.stops;
  return plan;
}

Json nearest_json(const arm::SceneSensor::Nearest& nearest) {
  return {{"distance", std::isfinite(nearest.distance) ? number(nearest.distance) : Json(nullptr)},
          {"link", text_or_null(nearest.link)},
          {"other", text_or_null(nearest.other)}};
}

/// What a call returns; its refusal of the question is the plan's error.
template <class Call>
void answered(arm::Result& plan, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_parameter) throw;
    plan.status = Status::invalid;
    plan.error = error.what();
  }
}

}  // namespace

void plan_straight(const ArmCommand& command, const arm::SceneSensor& sensor,
                   const StopCondition& stop, ArmAnswer& answer) {
  const arm::TipLineOptions options{.tolerance = command.straight_tolerance,
                                    .angle_tolerance = command.straight_angle,
                                    .stop = stop,
                                    .motion = true,
                                    .duration = command.duration};
  answer.straight_reached = -1;
  answered(answer.plan, [&] {
    for (std::size_t i = 0; i < answer.goals.size(); ++i) {
      const arm::TipLine line =
          arm::tip_line(answer.robot, sensor, answer.start, answer.goals[i].target, options);
      const bool told = line.status == Status::limit || line.status == Status::interrupted;
      const bool further =
          line.reached > answer.straight_reached ||
          (line.reached == answer.straight_reached && answer.plan.status == Status::invalid);
      if (!told && !further) continue;
      answer.straight_reached = line.reached;
      const bool moves = !line.trajectory.empty();
      answer.plan = moves ? result_of(answer.robot, line, static_cast<int>(i)) : arm::Result();
      answer.plan.status = line.status;
      answer.plan.limit = line.limit;
      answer.plan.error = line.error;
      if (moves || told) return;
    }
  });
  answer.straight_reached = std::max(0.0, answer.straight_reached);
}

void find_inverse(const ArmCommand& command, const arm::SceneSensor& sensor, ArmAnswer& answer) {
  answer.plan.status = Status::no_path;
  answer.plan.error = "no joint values were found that reach the goal, which is no proof";
  for (std::size_t i = 0; i < answer.goals.size(); ++i)
    answered(answer.plan, [&] {
      for (const arm::JointVector& q : arm::inverse_kinematics(
               answer.robot, answer.goals[i], answer.start, command.inverse, command.seed))
        answer.inverse.push_back({i, q, sensor.nearest(q), sensor.position_free(q)});
    });
  if (answer.inverse.empty()) return;
  const auto far = [&](const Reaching& reaching) { return (reaching.q - answer.start).norm(); };
  std::ranges::stable_sort(answer.inverse, {}, far);
  const auto most = static_cast<std::size_t>(command.inverse);
  if (answer.inverse.size() > most)
    answer.inverse.erase(answer.inverse.begin() + command.inverse, answer.inverse.end());
  answer.plan.status = Status::solved;
  answer.plan.error.clear();
  answer.plan.length = far(answer.inverse.front());
}

std::string nearest_text(const arm::SceneSensor::Nearest& nearest) {
  if (nearest.link.empty()) return "nothing is near";
  return to_text(nearest.distance) + " m between " + nearest.link + " and " + nearest.other;
}

void add_tip_json(const ArmCommand& command, const ArmAnswer& answer, Json& json) {
  if (command.straight)
    json["straight"] = {{"tolerance", number(command.straight_tolerance)},
                        {"angle_tolerance", number(command.straight_angle)},
                        {"reached", number(answer.straight_reached)}};
  if (command.inverse > 0) {
    Json found = Json::array();
    for (const Reaching& reaching : answer.inverse)
      found.push_back({{"goal", reaching.goal},
                       {"joints", joint_values_json(reaching.q)},
                       {"free", reaching.free},
                       {"nearest", nearest_json(reaching.nearest)}});
    json["inverse"] = {{"most", command.inverse}, {"found", std::move(found)}};
  }
  if (!answer.nearest.empty()) {
    const bool moved = answer.nearest.size() > 1;
    json["nearest"] = {{"start", nearest_json(answer.nearest.front())},
                       {"end", moved ? nearest_json(answer.nearest.back()) : Json(nullptr)}};
  }
}

void read_tip_options(const Json& result, ArmCommand& command) {
  command.straight = result.contains("straight");
  if (command.straight) {
    const auto off = [&](const char* key) {
      return recorded_real(result, key, ArmCommand::kLeastOff, ArmCommand::kMostTolerance);
    };
    command.straight_tolerance = off("straight/tolerance");
    command.straight_angle = off("straight/angle_tolerance");
  }
  if (result.contains("inverse"))
    command.inverse =
        static_cast<int>(recorded_integer(result, "inverse/most", 1, ArmCommand::kMostInverse));
  command.nearest = result.contains("nearest");
}

}  // namespace lasius::tool
