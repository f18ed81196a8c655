#include "tools/vehicle/vehicle_json.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lasius/base/error.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// More than -pi, at most pi.
double turned_once(double yaw) {
  const double turned = std::remainder(yaw, 2 * std::numbers::pi);
  return turned <= -std::numbers::pi ? std::numbers::pi : turned;
}

}  // namespace

double yaw_across(const LoadedMap& map, double yaw) { return turned_once(map.frame->yaw - yaw); }

vehicle::Pose to_world(const LoadedMap& map, const vehicle::Pose& cells) {
  const Point at = map.to_world(Point{cells.x, cells.y});
  return {at.x, at.y, yaw_across(map, cells.yaw)};
}

Json pose_json(const vehicle::Pose& pose) {
  return {number(pose.x), number(pose.y), number(pose.yaw)};
}

PoseEnd recorded_pose(const Json& result, const std::string& key) {
  const auto numbers = recorded<std::vector<double>>(result, key);
  if (numbers.size() != 3) throw UsageError("\"" + key + "\" is no [x, y, yaw]");
  return {{{numbers[0], numbers[1]}, true}, numbers[2]};
}
std::vector<PoseEnd> recorded_goals(const Json& result, bool metres) {
  const std::string goals = metres ? "goals_world" : "goals";
  if (!result.contains(goals)) return {recorded_pose(result, metres ? "goal_world" : "goal")};
  std::vector<PoseEnd> all;
  const Json& list = result[goals];
  if (!list.is_array() || list.empty()) throw UsageError("\"" + goals + "\" is " + dumped(list));
  all.reserve(list.size());
  for (const Json& goal : list) all.push_back(recorded_pose(Json{{goals, goal}}, goals));
  return all;
}

Json segments_json(const LoadedMap& map, const std::vector<vehicle::Segment>& segments,
                   bool metres) {
  Json list = Json::array();
  const double unit = metres ? map.metres(1) : 1;
  for (const vehicle::Segment& segment : segments) {
    const vehicle::Pose at = metres ? to_world(map, segment.begin) : segment.begin;
    const double sign = metres ? -1 : 1;  // y up: the other sense of turning
    Json one = {{"x", number(at.x)}, {"y", number(at.y)}, {"yaw", number(at.yaw)}};
    one["curvature"] = number(segment.curvature == 0 ? 0 : sign * segment.curvature / unit);
    one["curvature_rate"] =
        number(segment.curvature_rate == 0 ? 0 : sign * segment.curvature_rate / (unit * unit));
    if (segment.gear == 0)
      one["angle"] = number(sign * segment.angle);
    else
      one["length"] = number(unit * segment.length);
    if (segment.gear != 0 && segment.angle != 0) one["angle"] = number(sign * segment.angle);
    one["gear"] = segment.gear;
    list.push_back(std::move(one));
  }
  return list;
}

std::vector<vehicle::Segment> recorded_segments(const Json& result) {
  std::vector<vehicle::Segment> segments;
  const Json& list = value_at(result, "segments");
  if (!list.is_array()) throw UsageError("\"segments\" is no list");
  const auto real = [](const Json& of, const char* key) {
    return recorded_real(of, key, -kNoLimit, kNoLimit);
  };
  for (const Json& one : list) {
    vehicle::Segment segment{.begin = {real(one, "x"), real(one, "y"),
                                       recorded_real(one, "yaw", -kMostTurned, kMostTurned)},
                             .curvature = real(one, "curvature"),
                             .gear = static_cast<int>(recorded_integer(one, "gear", -1, 1))};
    segment.curvature_rate = real(one, "curvature_rate");
    if (segment.gear == 0 || one.contains("angle"))
      segment.angle = recorded_real(one, "angle", -kMostTurned, kMostTurned);
    if (segment.gear != 0) segment.length = recorded_real(one, "length", 0, kNoLimit);
    segments.push_back(segment);
  }
  return segments;
}

std::span<const SpeedKey> speed_keys() {
  using vehicle::SpeedLimits;
  static constexpr SpeedKey kKeys[] = {
      {"speed", &SpeedLimits::speed, true},
      {"reverse_speed", &SpeedLimits::reverse_speed, true},
      {"acceleration", &SpeedLimits::acceleration, true},
      {"braking", &SpeedLimits::braking, true},
      {"lateral_acceleration", &SpeedLimits::lateral_acceleration, true},
      {"turn_rate", &SpeedLimits::turn_rate, false},
      {"turn_acceleration", &SpeedLimits::turn_acceleration, false}};
  return kKeys;
}

Json speeds_json(const vehicle::SpeedLimits& speeds) {
  Json json = Json::object();
  for (const SpeedKey& key : speed_keys()) json[std::string(key.key)] = number(speeds.*key.value);
  return json;
}

vehicle::SpeedLimits recorded_speeds(const Json& parameters) {
  vehicle::SpeedLimits speeds;
  const Json& from = value_at(parameters, "speeds");
  for (const SpeedKey& key : speed_keys()) {
    const std::string name(key.key);
    if (!value_at(from, name).is_null())
      speeds.*key.value = recorded_real(from, name, std::numeric_limits<double>::min(), kNoLimit);
  }
  return speeds;
}

Json vehicle_json(const vehicle::Vehicle& vehicle) {
  return {{"footprint", points(vehicle.footprint)},
          {"turning_radius", number(vehicle.turning_radius)},
          {"reverse", vehicle.reverse},
          {"reverse_cost", number(vehicle.reverse_cost)},
          {"cusp_cost", number(vehicle.cusp_cost)},
          {"rotate_in_place", vehicle.rotate_in_place},
          {"rotation_cost", number(vehicle.rotation_cost)},
          {"sideways", vehicle.sideways},
          {"curvature_rate", number(vehicle.curvature_rate)}};
}

vehicle::Vehicle recorded_vehicle(const Json& parameters) {
  const Json& from = value_at(parameters, "vehicle");
  vehicle::Vehicle vehicle;
  const Json& corners = value_at(from, "footprint");
  if (!corners.is_array()) throw UsageError("\"footprint\" is no list of corners");
  for (const Json& corner : corners)
    vehicle.footprint.push_back(recorded_point(Json{{"footprint", corner}}, "footprint"));
  const auto real = [&](const char* key) { return recorded_real(from, key, 0, kNoLimit); };
  vehicle.turning_radius = real("turning_radius");
  vehicle.reverse = recorded<bool>(from, "reverse");
  vehicle.reverse_cost = real("reverse_cost");
  vehicle.cusp_cost = real("cusp_cost");
  vehicle.rotate_in_place = recorded<bool>(from, "rotate_in_place");
  vehicle.rotation_cost = real("rotation_cost");
  vehicle.sideways = from.contains("sideways") && recorded<bool>(from, "sideways");
  if (from.contains("curvature_rate")) vehicle.curvature_rate = real("curvature_rate");
  try {
    validate(vehicle);
  } catch (const Error& error) {
    throw UsageError(std::string("the result's vehicle: ") + error.what());
  }
  return vehicle;
}

}  // namespace lasius::tool
