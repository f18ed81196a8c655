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

Json nearest_json(const arm::SceneSensor::Nearest& nearest) {
  return {{"distance", std::isfinite(nearest.distance) ? number(nearest.distance) : Json(nullptr)},
          {"link", text_or_null(nearest.link)},
          {"other", text_or_null(nearest.other)}};
}

/// What a call returns; its refusal of the question is the plan's error.
template <class Call>
bool answered(arm::Result& plan, const Call& call) {
  try {
    call();
    return true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_parameter) throw;
    plan.status = Status::invalid;
    plan.error = error.what();
    return false;
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
      answer.plan = {};
      if (moves) {
        answer.plan = line;
        answer.plan.goal = static_cast<int>(i);
      }
      answer.plan.status = line.status;
      answer.plan.limit = line.limit;
      answer.plan.error = line.error;
      if (moves || told) return;
    }
  });
  answer.straight_reached = std::max(0.0, answer.straight_reached);
}

void find_inverse(const ArmCommand& command, const arm::SceneSensor& sensor,
                  const StopCondition& stop, ArmAnswer& answer) {
  arm::Result& plan = answer.plan;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < answer.goals.size(); ++i)
    asked += answered(plan, [&] {
      for (const arm::JointVector& q : arm::inverse_kinematics(
               answer.robot, answer.goals[i], answer.start, command.inverse, command.seed, stop))
        answer.inverse.push_back({i, q, sensor.nearest(q), sensor.position_free(q)});
    });
  if (asked == 0) return;
  const auto far = [&](const Reaching& reaching) { return (reaching.q - answer.start).norm(); };
  std::ranges::stable_sort(answer.inverse, {}, far);
  const auto most = static_cast<std::size_t>(command.inverse);
  if (answer.inverse.size() > most)
    answer.inverse.erase(answer.inverse.begin() + command.inverse, answer.inverse.end());
  plan.error.clear();
  const auto cause = stop.poll();
  if (cause == StopCondition::Cause::token) {
    plan.status = Status::interrupted;
  } else if (cause == StopCondition::Cause::deadline) {
    plan.status = Status::limit;
    plan.limit = Limit::time;
  } else if (answer.inverse.empty()) {
    plan.status = Status::no_path;
    plan.error = "no joint values were found that reach the goal, which is no proof";
  } else if (std::ranges::none_of(answer.inverse, &Reaching::free)) {
    plan.status = Status::invalid;
    plan.fault = Fault::goal_blocked;
    plan.error = "the arm touches something in each of " +
                 counted(std::ssize(answer.inverse), "posture") +
                 " found: " + sensor.contact(answer.inverse.front().q);
  } else {
    plan.status = Status::solved;
    plan.length = far(answer.inverse.front());
  }
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
