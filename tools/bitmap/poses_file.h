// The poses along a path, as JSON and files tell them.
#pragma once

#include <iosfwd>
#include <vector>

#include "lasius/path/poses.h"
#include "tools/bitmap/answer.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

/// Cells between poses, as asked for, else half a one.
double spacing_of(const LoadedMap& map, const RunOptions& run);

/// Poses along an answer, in cells, or in metres of the map's frame where `metres`.
std::vector<lasius::Pose> poses_of(const LoadedMap& map, const RunOptions& run,
                                   const Answer& answer, bool metres);

/// [[x, y, yaw], ...]; null without a path.
Json poses_json(const std::vector<lasius::Pose>& poses);

/// As nav_msgs/Path, in the frame "map": metres, or cells, y down, of a map without a frame.
void write_ros_path(std::ostream& out, const std::vector<lasius::Pose>& poses);

/// x,y,yaw, or x_m,y_m,yaw of metres; a line a pose.
void write_pose_table(std::ostream& out, const std::vector<lasius::Pose>& poses, bool metres);

}  // namespace lasius::tool
