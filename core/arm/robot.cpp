#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/arm/json_fields.h"
#include "core/arm/kinematics.h"
#include "core/arm/urdf.h"
#include "core/arm/vec3.h"
#include "core/base/output.h"
#include "core/map_files/byte_reader.h"
#include "lasius/arm_robot.h"
#include "lasius/error.h"

namespace lasius::arm {
namespace {

constexpr double kMostTurn = 1000;  // radians

Robot parse_short(std::string_view text, const std::string& file) {
  const auto document = parse_json(text, file, "lasius-arm/1");
  const JsonFields top(*document, text, file, "",
                       {"format", "name", "base", "base_radius", "joints", "may_touch"});
  Robot robot;
  robot.name = top.text_or("name", "");
  // The base is a post from the ground to the first joint.
  const Vec3 base = top.vector_or("base", kFar, {});
  const double base_radius = top.number_or("base_radius", 0, kFar, 0);
  if (base_radius > 0) robot.base.push_back({Vec3(base.x, base.y, 0), base, base_radius});
  Vec3 origin = base;
  for (const JsonFields& fields :
       top.list("joints", 1, Robot::kMaxJoints,
                {"name", "type", "axis", "link", "radius", "limits", "velocity", "acceleration"})) {
    Joint joint;
    joint.name = fields.text_or("name", "");
    const std::string type = fields.text_or("type", "revolute");
    if (type != "revolute" && type != "prismatic") {
      fields.fail("type", "is \"" + type + "\"", "it must be \"revolute\" or \"prismatic\"");
    }
    joint.kind = type == "prismatic" ? Joint::Kind::prismatic : Joint::Kind::revolute;
    const Vec3 axis = fields.vector("axis", kFar);
    if (!(length(axis) > 1e-9)) fields.fail("axis", "has no length", "as in [0, 0, 1]");
    joint.axis = (1 / length(axis)) * axis;
    std::tie(joint.low, joint.high) = fields.range("limits", kMostTurn);
    joint.velocity = fields.number_or("velocity", 1e-6, 1e6, 1);
    joint.acceleration = fields.number_or("acceleration", 1e-6, 1e6, 4);
    joint.frame.translation() = Eigen::Vector3d(origin);
    const Vec3 link = fields.vector("link", kFar);
    const double radius = fields.number_or("radius", 0, kFar, 0);
    if (radius > 0) joint.capsules.push_back({Vec3(), link, radius});
    origin = link;
    robot.joints.push_back(std::move(joint));
  }
  robot.tip = origin;
  robot.may_touch = top.pairs("may_touch", robot.size());
  return robot;
}

void refuse(const std::string& problem, const std::string& remedy) {
  throw Error(ErrorCode::invalid_parameter, problem, remedy);
}

bool finite(Vec3 v) { return std::isfinite(v.x + v.y + v.z) && length(v) <= 2 * kFar; }

void check_rotation(const Pose& pose, const std::string& what) {
  const Rotation r = from_eigen(pose).rotation;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      double product = 0;
      for (int k = 0; k < 3; ++k) product += r[3 * i + k] * r[3 * j + k];
      if (!(std::abs(product - (i == j)) < 1e-6)) {
        refuse(what + ": its rotation is none", "its rows must be orthonormal");
      }
    }
  }
}

/// Where the body is that moves with each joint.
std::vector<Placement> place(const Robot& robot, const JointRef& q) {
  validate(robot);
  check_values(robot, as_span(q));
  Kinematics::Poses poses;
  Kinematics(robot).place(as_span(q), poses);
  return {poses.begin(), poses.begin() + robot.size()};
}

}  // namespace

template <int AlignBytes, bool ByMalloc>
bool compile_with_the_Eigen_alignment_of_lasius() noexcept {
  return true;
}
template bool compile_with_the_Eigen_alignment_of_lasius<EIGEN_DEFAULT_ALIGN_BYTES,
                                                         EIGEN_MALLOC_ALREADY_ALIGNED>() noexcept;

Robot parse_robot(std::string_view text, const std::string& file, const Chain& chain) {
  const auto first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const char begins = first == std::string_view::npos ? '\0' : text[first];
  const bool named = has_ending(file, ".urdf") || has_ending(file, ".xml");
  if (begins == '<' || (named && begins != '{')) return parse_urdf(text, file, chain);
  Robot robot = parse_short(text, file);
  if (!chain.base.empty() || !chain.tip.empty()) {
    refuse("a chain was asked for, but " + file + " is no URDF file",
           "leave its base and tip link out");
  }
  return robot;
}

Robot read_robot(const std::string& path, const Chain& chain) {
  constexpr std::int64_t kMostBytes = 16 << 20;
  return parse_robot(read_text(path, kMostBytes), path, chain);
}

void validate(const Robot& robot) {
  if (robot.joints.empty() || robot.size() > Robot::kMaxJoints) {
    refuse("the robot has " + std::to_string(robot.joints.size()) + " joints",
           "it must have 1 .. " + std::to_string(Robot::kMaxJoints));
  }
  std::size_t capsules = robot.base.size();
  const auto check_capsules = [](const std::vector<Capsule>& list, const std::string& what) {
    for (const Capsule& c : list) {
      if (!finite(c.from) || !finite(c.to) || !(c.radius >= 0 && c.radius <= kFar)) {
        refuse(what + " has a capsule out of range", "its numbers must be within 1000 m");
      }
    }
  };
  check_capsules(robot.base, "the base");
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const std::string what = "joint " + std::to_string(j + 1);
    if (!finite(from_eigen(joint.frame).position)) {
      refuse(what + ": its origin is out of range", "within 1000 m");
    }
    check_rotation(joint.frame, what);
    if (!(std::abs(length(joint.axis) - 1) < 1e-6)) {
      refuse(what + ": its axis is not of length 1", "divide it by its length");
    }
    if (!(joint.low <= joint.high && joint.low >= -kMostTurn && joint.high <= kMostTurn)) {
      refuse(what + ": its limits are not in order", "-1000 <= low <= high <= 1000");
    }
    if (!(joint.velocity > 0 && joint.velocity <= 1e6 && joint.acceleration > 0 &&
          joint.acceleration <= 1e6)) {
      refuse(what + ": velocity or acceleration is out of range", "above 0, at most 1e6");
    }
    check_capsules(joint.capsules, what);
    capsules += joint.capsules.size();
  }
  if (!finite(robot.tip)) refuse("the tip is out of range", "within 1000 m");
  if (capsules > 128) {
    refuse("the robot has " + std::to_string(capsules) + " capsules", "at most 128 fit");
  }
}

void validate(const Scene& scene) {
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const Obstacle& o = scene.obstacles[i];
    const std::string what = "obstacle " + std::to_string(i + 1);
    const auto size = [&](double v, const char* name) {
      if (!(v > 0 && v <= kFar)) {
        refuse(what + ": its " + name + " is out of range", "above 0, at most 1000 m");
      }
    };
    if (!finite(from_eigen(o.pose).position)) {
      refuse(what + ": its position is out of range", "within 1000 m");
    }
    check_rotation(o.pose, what);
    switch (o.shape) {
      case Obstacle::Shape::box:
        size(std::min({o.size[0], o.size[1], o.size[2]}), "size");
        size(std::max({o.size[0], o.size[1], o.size[2]}), "size");
        break;
      case Obstacle::Shape::cylinder:
        size(o.length, "length");
        [[fallthrough]];
      case Obstacle::Shape::sphere:
        size(o.radius, "radius");
        break;
      case Obstacle::Shape::mesh:
        for (const auto& triangle : o.triangles) {
          for (const Eigen::Vector3d& corner : triangle) {
            if (!finite(corner)) refuse(what + ": a corner is out of range", "within 1000 m");
          }
        }
        break;
    }
  }
}

Eigen::Vector3d tip_position(const Robot& robot, const JointRef& q) {
  return place(robot, q).back() * Vec3(robot.tip);
}

Pose tip_pose(const Robot& robot, const JointRef& q) {
  const Placement last = place(robot, q).back();
  return to_eigen({last.rotation, last * Vec3(robot.tip)});
}

std::vector<Capsule> place_capsules(const Robot& robot, const JointRef& q) {
  const std::vector<Placement> poses = place(robot, q);
  std::vector<Capsule> placed = robot.base;
  for (int j = 0; j < robot.size(); ++j) {
    for (const Capsule& c : robot.joints[j].capsules) {
      placed.push_back({poses[j] * Vec3(c.from), poses[j] * Vec3(c.to), c.radius});
    }
  }
  return placed;
}

}  // namespace lasius::arm
