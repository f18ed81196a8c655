#include "tools/bitmap/poses_file.h"

#include <cmath>
#include <ostream>

#include "tools/console/values.h"

namespace lasius::tool {

double spacing_of(const LoadedMap& map, const RunOptions& run) {
  constexpr double kUsual = 0.5;
  return run.spacing ? map.cells_of(run.map.radius_metres, *run.spacing) : kUsual;
}

std::vector<Pose> poses_of(const LoadedMap& map, const RunOptions& run, const Answer& answer,
                           bool metres) {
  std::vector<Pose> along = poses(answer.result, spacing_of(map, run));
  if (metres)
    for (Pose& pose : along) {
      const auto [x, y] = in_metres(map, run, answer, {pose.x, pose.y});
      pose = {x, y, to_world(*map.frame, pose, map.height).yaw};
    }
  return along;
}

Json poses_json(const std::vector<Pose>& poses) {
  if (poses.empty()) return nullptr;
  Json json = Json::array();
  for (const Pose& pose : poses) json.push_back({number(pose.x), number(pose.y), number(pose.yaw)});
  return json;
}

void write_ros_path(std::ostream& out, const std::vector<Pose>& poses) {
  constexpr const char* kHeader = "{stamp: {sec: 0, nanosec: 0}, frame_id: map}\n";
  out << "header: " << kHeader << (poses.empty() ? "poses: []\n" : "poses:\n");
  for (const auto& [x, y, yaw] : poses)
    out << "- header: " << kHeader << "  pose:\n    position: {x: " << yaml_real(x)
        << ", y: " << yaml_real(y)
        << ", z: 0.0}\n    orientation: {x: 0.0, y: 0.0, z: " << yaml_real(std::sin(yaw / 2))
        << ", w: " << yaml_real(std::cos(yaw / 2)) << "}\n";
}

void write_pose_table(std::ostream& out, const std::vector<Pose>& poses, bool metres) {
  out << (metres ? "x_m,y_m,yaw\n" : "x,y,yaw\n");
  for (const auto& [x, y, yaw] : poses)
    out << to_text(x) << "," << to_text(y) << "," << to_text(yaw) << "\n";
}

}  // namespace lasius::tool
