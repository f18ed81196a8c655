// Poses, segments and vehicles as JSON, in cells and in metres.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/profile.h"
#include "lasius/vehicle/vehicle.h"
#include "tools/bitmap/map_file.h"
#include "tools/options/options.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

/// Yaws are at most so many radians, of either sign.
inline constexpr double kMostTurned = 1e5;

/// A yaw of the map's frame as one of cells and, by the same sum, back: more than -pi, at most pi.
double yaw_across(const LoadedMap& map, double yaw);
/// A pose in cells in metres of the map's frame.
vehicle::Pose to_world(const LoadedMap& map, const vehicle::Pose& cells);

/// [x, y, yaw]
Json pose_json(const vehicle::Pose& pose);
/// A start or goal of a result, by its key. @throws UsageError
PoseEnd recorded_pose(const Json& result, const std::string& key);
/// Its goals, in their order, of whichever frame was asked in. @throws UsageError
std::vector<PoseEnd> recorded_goals(const Json& result, bool metres);
/// A list of segments from which every pose follows; `metres`: in the map's frame.
Json segments_json(const LoadedMap& map, const std::vector<vehicle::Segment>& segments,
                   bool metres);
/// Back, of a result's "segments". @throws UsageError
std::vector<vehicle::Segment> recorded_segments(const Json& result);

/// A vehicle in cells, whole. And back, validated. @throws UsageError
Json vehicle_json(const vehicle::Vehicle& vehicle);
vehicle::Vehicle recorded_vehicle(const Json& parameters);
/// Its limits of speed, null where there is none. And back. @throws UsageError
Json speeds_json(const vehicle::SpeedLimits& speeds);
vehicle::SpeedLimits recorded_speeds(const Json& parameters);

/// The limits by the names that files have; `length`: of cells, else of radians.
struct SpeedKey {
  std::string_view key;
  double vehicle::SpeedLimits::*value;
  bool length;
};
std::span<const SpeedKey> speed_keys();

}  // namespace lasius::tool
