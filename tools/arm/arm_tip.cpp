#include "tools/arm/arm_tip.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lasius/arm/plan.h"
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
