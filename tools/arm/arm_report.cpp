#include "tools/arm/arm_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "tools/arm/arm_json.h"
#include "tools/arm/arm_outline.h"
#include "tools/arm/arm_picture.h"
#include "tools/arm/arm_samples.h"
#include "tools/report/packed.h"
#include "tools/report/report.h"

namespace lasius::tool {
namespace {

using Eigen::Vector3d;

constexpr int kMostTimes = 240;
constexpr double kFarAway = 1e6;              // metres: nothing is near
constexpr std::size_t kMostTriangles = 6000;  // of all meshes together

/// The rows of its 3 x 4 matrix.
std::vector<double> numbers_of(const arm::Pose& pose) {
  std::vector<double> numbers;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) numbers.push_back(pose.matrix()(row, column));
  return numbers;
}

/// A mesh with corners moved to the middle of cubes of edge `pitch`: those that lie within one, and
/// repeated ones, are gone. Pitch 0: as it is.
std::vector<std::array<Vector3d, 3>> coarse(const arm::Triangles& mesh, double pitch) {
  if (pitch <= 0) return mesh;
  std::vector<std::array<Vector3d, 3>> kept;
  std::set<std::array<std::array<long, 3>, 3>> known;
  for (const auto& triangle : mesh) {
    std::array<std::array<long, 3>, 3> cubes{};
    std::array<Vector3d, 3> moved;
    for (std::size_t i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const long cube = std::lround(triangle[i][axis] / pitch);
        cubes[i][static_cast<std::size_t>(axis)] = cube;
        moved[i][axis] = pitch * static_cast<double>(cube);
      }
    if (cubes[0] == cubes[1] || cubes[1] == cubes[2] || cubes[0] == cubes[2]) continue;
    std::ranges::sort(cubes);
    if (known.insert(cubes).second) kept.push_back(moved);
  }
  return kept;
}

/// The solids of a run, each with the body that it moves with.
struct Body {
  int number;
  const arm::Solid* solid;
};

std::vector<Body> bodies_of(const ArmAnswer& answer) {
  std::vector<Body> bodies;
  for (const auto& obstacle : answer.scene.obstacles) bodies.push_back({-1, &obstacle});
  for (const arm::Link& link : answer.robot.links)
    for (const arm::Solid& solid : link.solids) bodies.push_back({link.body, &solid});
  return bodies;
}

/// An edge of cubes with which all meshes together have few enough triangles.
double mesh_pitch(const std::vector<Body>& bodies) {
  for (double pitch = 0;; pitch = pitch > 0 ? 1.5 * pitch : 0.002) {
    std::size_t count = 0;
    for (const Body& body : bodies)
      if (body.solid->triangles) count += coarse(*body.solid->triangles, pitch).size();
    if (count <= kMostTriangles) return pitch;
  }
}

Json solids_json(const ArmAnswer& answer) {
  const auto bodies = bodies_of(answer);
  const double pitch = mesh_pitch(bodies);
  Json list = Json::array();
  for (const auto& [number_of, solid] : bodies) {
    Json json = {{"body", number_of},
                 {"shape", to_string(solid->shape)},
                 {"pose", numbers(numbers_of(solid->pose))},
                 {"size", vector_json(solid->size)},
                 {"radius", number(solid->radius)},
                 {"length", number(solid->length)}};
    if (solid->triangles) {
      std::vector<float> corners;
      for (const auto& triangle : coarse(*solid->triangles, pitch))
        for (const Vector3d& corner : triangle)
          for (const double value : corner) corners.push_back(static_cast<float>(value));
      json["triangles"] = packed(corners);
    }
    list.push_back(std::move(json));
  }
  return list;
}

/// Times that are shown; only the start where nothing moves.
std::vector<double> times_of(const ArmAnswer& answer) {
  const double duration = answer.plan.trajectory.empty() ? 0 : answer.plan.trajectory.duration();
  if (!(duration > 0)) return {0};
  const int count = std::clamp(static_cast<int>(std::ceil(30 * duration)), 30, kMostTimes);
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(duration * i / count);
  return times;
}

Json motion_json(const ArmAnswer& answer) {
  std::vector<float> joints, poses, tips, distances;
  const arm::SceneSensor sensor(answer.robot, answer.scene);
  const auto times = times_of(answer);
  const auto add = [](std::vector<float>& list, const auto& numbers) {
    for (const double value : numbers) list.push_back(static_cast<float>(value));
  };
  for (const double t : times) {
    const arm::JointVector q =
        answer.plan.trajectory.empty() ? answer.start : answer.plan.trajectory.at(t).q;
    add(joints, q);
    add(tips, arm::tip_position(answer.robot, q));
    distances.push_back(static_cast<float>(std::min(sensor.distance(q), kFarAway)));
    for (const arm::Pose& pose : body_poses(answer.robot, q)) add(poses, numbers_of(pose));
  }
  return {{"times", numbers(times)},        {"names", joint_names(answer.robot)},
          {"joints", packed(joints)},       {"tips", packed(tips)},
          {"distances", packed(distances)}, {"far_away", kFarAway},
          {"poses", packed(poses)}};
}

}  // namespace

void write_arm_report(std::ostream& out, const Record& run, const ArmCommand& command,
                      const ArmAnswer& answer) {
  Json content = run_json(run, "arm", arm_title(command, answer));
  content["solids"] = solids_json(answer);
  content["motion"] = motion_json(answer);
  const Eigen::AlignedBox3d bounds = bounds_of(answer);
  content["low"] = vector_json(bounds.min());
  content["high"] = vector_json(bounds.max());
  content["lattice"] = Json::array();
  if (!answer.plan.direct && !answer.plan.trees)
    for (const Vector3d p : answer.plan.tips.colwise())
      content["lattice"].push_back(vector_json(p));
  content["goals"] = Json::array();
  for (const arm::Goal& goal : answer.goals)
    content["goals"].push_back(vector_json(tip_of(answer.robot, goal)));
  content["asked"] = asked_json(answer.plan.asked);
  write_report_page(out, content);
}

}  // namespace lasius::tool
