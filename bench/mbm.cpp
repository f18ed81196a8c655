#include "bench/mbm.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "lasius/base/error.h"

namespace lasius::bench {
namespace {

Eigen::Vector3d vector_of(const YAML::Node& node) {
  return {node[0].as<double>(), node[1].as<double>(), node[2].as<double>()};
}

arm::Pose pose_of(const YAML::Node& node) {
  const YAML::Node turn = node["orientation"];
  arm::Pose pose = arm::Pose::Identity();
  pose.translation() = vector_of(node["position"]);
  pose.linear() = Eigen::Quaterniond(turn[3].as<double>(), turn[0].as<double>(),
                                     turn[1].as<double>(), turn[2].as<double>())
                      .normalized()
                      .toRotationMatrix();
  return pose;
}

arm::Scene scene_of(const std::string& file) {
  arm::Scene scene{.name = file, .obstacles = {}};
  for (const YAML::Node& object : YAML::LoadFile(file)["world"]["collision_objects"]) {
    for (std::size_t i = 0; i < object["primitives"].size(); ++i) {
      const YAML::Node primitive = object["primitives"][i], sizes = primitive["dimensions"];
      const auto kind = primitive["type"].as<std::string>();
      arm::Obstacle obstacle;
      obstacle.name = object["id"].as<std::string>();
      obstacle.pose = pose_of(object["primitive_poses"][i]);
      if (object["pose"]) obstacle.pose = pose_of(object["pose"]) * obstacle.pose;
      if (kind == "box") {
        obstacle.size = vector_of(sizes);
      } else if (kind == "cylinder") {
        obstacle.shape = arm::Solid::Shape::cylinder;
        obstacle.length = sizes[0].as<double>();
        obstacle.radius = sizes[1].as<double>();
      } else if (kind == "sphere") {
        obstacle.shape = arm::Solid::Shape::sphere;
        obstacle.radius = sizes[0].as<double>();
      } else {
        throw Error(ErrorCode::file_unsupported, {.file = file}, "a primitive is a " + kind,
                    "box, cylinder and sphere are read");
      }
      scene.obstacles.push_back(std::move(obstacle));
    }
  }
  return scene;
}

/// The values of the robot's joints among others.
template <class ValueOf>
arm::JointVector values_of(const arm::Robot& robot, const ValueOf& value_of) {
  arm::JointVector q(robot.size());
  for (int j = 0; j < robot.size(); ++j) q[j] = value_of(robot.joints[j].name);
  return q;
}

double find(const YAML::Node& names, const YAML::Node& values, const std::string& name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].as<std::string>() == name) return values[i].as<double>();
  return 0;
}

double goal_of(const YAML::Node& constraints, const std::string& name) {
  for (const YAML::Node& one : constraints)
    if (one["joint_name"].as<std::string>() == name) return one["position"].as<double>();
  return 0;
}

}  // namespace

arm::Robot read_mbm_robot(const std::string& folder, const std::string& name,
                          const std::string& base, const std::string& tip) {
  return arm::read_robot(folder + "/" + name + ".urdf",
                         {.base = base,
                          .tip = tip,
                          .srdf = folder + "/" + name + ".srdf",
                          .packages = {{"meshes", folder + "/meshes"}}});
}

std::vector<MbmProblem> read_mbm_problems(const std::string& problems, const arm::Robot& robot) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  if (fs::is_directory(problems)) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(problems))
      if (entry.path().filename().string().starts_with("request")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  if (files.empty()) {
    throw Error(ErrorCode::file_missing, {.file = problems}, "it holds no requestNNNN.yaml",
                "unpack problems.tar.bz2 of the robot and name its folder with --problems");
  }
  std::vector<MbmProblem> read;
  for (const fs::path& file : files) {
    const std::string number = file.stem().string().substr(7);
    const YAML::Node request = YAML::LoadFile(file.string());
    const YAML::Node start = request["start_state"]["joint_state"],
                     goal = request["goal_constraints"][0]["joint_constraints"];
    read.push_back(
        {file.parent_path().filename().string(), std::stoi(number),
         scene_of((file.parent_path() / ("scene" + number + ".yaml")).string()),
         values_of(
             robot,
             [&](const std::string& name) { return find(start["name"], start["position"], name); }),
         values_of(robot, [&](const std::string& name) { return goal_of(goal, name); })});
  }
  return read;
}

}  // namespace lasius::bench
