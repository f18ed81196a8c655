#include "lasius/arm/robot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "core/arm/robot/json_fields.h"
#include "core/arm/robot/kinematics.h"
#include "core/arm/robot/solid.h"
#include "core/arm/robot/urdf.h"
#include "core/arm/robot/vec3.h"
#include "core/base/file_kind.h"
#include "core/base/invalid_parameter.h"
#include "core/base/output.h"
#include "core/map_files/byte_reader.h"

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
  robot.links.emplace_back();
  if (base_radius > 0)
    robot.links[0].solids = {capsule({base.x, base.y, 0}, {0, 0, base.z}, base_radius)};
  Vec3 origin = base;
  std::string bare;  // joints whose links have no body
  for (const JsonFields& fields : top.list("joints", 1, Robot::kMaxJoints,
                                           {"name", "type", "axis", "link", "radius", "limits",
                                            "velocity", "acceleration", "jerk"})) {
    Joint joint;
    joint.name = fields.text_or("name", "");
    const auto same = [&](const Joint& other) { return other.name == joint.name; };
    if (!joint.name.empty() && std::ranges::any_of(robot.joints, same))
      fields.fail("name", "is another joint's, too", "give each joint a name of its own");
    const std::string type = fields.text_or("type", "revolute");
    if (type != "revolute" && type != "prismatic")
      fields.fail("type", "is \"" + type + "\"", "it must be \"revolute\" or \"prismatic\"");
    joint.kind = type == "prismatic" ? Joint::Kind::prismatic : Joint::Kind::revolute;
    const Vec3 axis = fields.vector("axis", kFar);
    if (!(length(axis) > 1e-9)) fields.fail("axis", "has no length", "as in [0, 0, 1]");
    joint.axis = (1 / length(axis)) * axis;
    std::tie(joint.low, joint.high) = fields.range("limits", kMostTurn);
    joint.velocity = fields.number_or("velocity", 1e-6, 1e6, 1);
    joint.acceleration = fields.number_or("acceleration", 1e-6, 1e6, 4);
    joint.jerk = fields.number_or("jerk", 0, 1e9, 0);
    joint.frame.translation() = Eigen::Vector3d(origin);
    const Vec3 link = fields.vector("link", kFar);
    const double radius = fields.number_or("radius", 0, kFar, -1);  // as not given
    const int number = robot.size();
    if (radius < 0) bare += (bare.empty() ? "" : ", ") + std::to_string(number);
    robot.joints.push_back(std::move(joint));
    robot.links.push_back({.name = {}, .body = number + 1, .parent = number, .solids = {}});
    if (radius > 0) robot.links.back().solids = {capsule({}, link, radius)};
    origin = link;
  }
  if (!bare.empty())
    robot.notes.push_back("without a \"radius\" links have no body: those of joints " + bare);
  robot.tip.translation() = Eigen::Vector3d(origin);
  robot.may_touch = top.pairs("may_touch", robot.size());
  return robot;
}

bool finite(Vec3 v) { return std::isfinite(v.x + v.y + v.z) && length(v) <= 2 * kFar; }

void check_rotation(const Pose& pose, const std::string& what) {
  const Rotation r = from_eigen(pose).rotation;
  bool good = dot(cross({r[0], r[1], r[2]}, {r[3], r[4], r[5]}), {r[6], r[7], r[8]}) > 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      double product = 0;
      for (int k = 0; k < 3; ++k) product += r[3 * i + k] * r[3 * j + k];
      good = good && std::abs(product - (i == j)) < 1e-6;
    }
  }
  if (!good)
    refuse(what + ": its rotation is none", "its rows must be orthonormal, its determinant 1");
}

/// Whether the corners of meshes are looked at, too.
enum class Corners { looked_at, left_out };

void check_solid(const Solid& s, const std::string& what, Corners corners) {
  if (const int shape = static_cast<int>(s.shape); shape < 0 || shape >= std::ssize(kShapeNames))
    refuse(what + ": its shape is " + std::to_string(shape), "0 is a box, 4 a capsule");
  const auto size = [&](double v, const char* name) {
    if (!(v > 0 && v <= kFar))
      refuse(what + ": its " + name + " is out of range",
             "above 0 (of a capsule 0 or more), at most 1000 m");
  };
  if (!finite(from_eigen(s.pose).position))
    refuse(what + ": its position is out of range", "within 1000 m");
  check_rotation(s.pose, what);
  switch (s.shape) {
    case Solid::Shape::box:
      size(std::min({s.size[0], s.size[1], s.size[2]}), "size");
      size(std::max({s.size[0], s.size[1], s.size[2]}), "size");
      break;
    case Solid::Shape::cylinder:
      size(s.length, "length");
      [[fallthrough]];
    case Solid::Shape::sphere:
      size(s.radius, "radius");
      break;
    case Solid::Shape::capsule:
      if (s.radius != 0) size(s.radius, "radius");
      if (!finite(s.size)) refuse(what + ": its size is out of range", "within 1000 m");
      break;
    case Solid::Shape::mesh:
      if (s.triangles == nullptr || corners == Corners::left_out) break;
      for (const auto& triangle : *s.triangles) {
        for (const Eigen::Vector3d& corner : triangle)
          if (!finite(corner)) refuse(what + ": a corner is out of range", "within 1000 m");
      }
      break;
  }
}

void check_links(const Robot& robot, Corners corners) {
  const int count = static_cast<int>(robot.links.size());
  std::size_t solids = 0;
  const auto field = [&](int i, const char* name, int value) {
    return "links[" + std::to_string(i) + "]." + name + " is " + std::to_string(value);
  };
  for (int i = 0; i < count; ++i) {
    const Link& link = robot.links[i];
    if (link.body < 0 || link.body > robot.size())
      refuse(field(i, "body", link.body),
             "0 is the base, the last joint is " + std::to_string(robot.size()));
    if (link.parent < -1 || link.parent >= count)
      refuse(field(i, "parent", link.parent), "links are counted from 0, -1 is none");
    const std::string what = link_name(robot, i);
    for (const Solid& solid : link.solids) check_solid(solid, what, corners);
    solids += link.solids.size();
  }
  std::vector<int> seen(count, -1);  // on the way from which link
  for (int i = 0; i < count; ++i) {
    int at = i;
    for (; at >= 0 && seen[at] < 0; at = robot.links[at].parent) seen[at] = i;
    if (at >= 0 && seen[at] == i)
      refuse(field(at, "parent", robot.links[at].parent), "no link may hang on itself, in a loop");
  }
  if (solids > Robot::kMaxSolids)
    refuse("the robot has " + std::to_string(solids) + " solids",
           "at most " + std::to_string(Robot::kMaxSolids) + " are checked");
  for (const auto& [a, b] : robot.may_touch) {
    if (a < 0 || b < 0 || a >= count || b >= count)
      refuse("may_touch names links " + std::to_string(a) + " and " + std::to_string(b),
             "links are counted from 0 to " + std::to_string(count - 1));
  }
}

void check(const Robot& robot, Corners corners) {
  if (robot.joints.empty() || robot.size() > Robot::kMaxJoints)
    refuse("the robot has " + std::to_string(robot.joints.size()) + " joints",
           "it must have 1 .. " + std::to_string(Robot::kMaxJoints));
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const std::string what = joint_name(robot, j);
    if (!finite(from_eigen(joint.frame).position))
      refuse(what + ": its origin is out of range", "within 1000 m");
    check_rotation(joint.frame, what);
    if (!(std::abs(length(joint.axis) - 1) < 1e-6))
      refuse(what + ": its axis is not of length 1", "divide it by its length");
    if (!(joint.low <= joint.high && joint.low >= -kMostTurn && joint.high <= kMostTurn))
      refuse(what + ": its limits are not in order", "-1000 <= low <= high <= 1000");
    const auto is_limit = [](double v) { return v >= 1e-9 && v <= 1e6; };
    if (!is_limit(joint.velocity) || !is_limit(joint.acceleration))
      refuse(what + ": velocity or acceleration is out of range", "1e-9 .. 1e6");
    if (!(joint.jerk == 0 || (joint.jerk >= 1e-9 && joint.jerk <= 1e9)))
      refuse(what + ": its jerk is out of range", "1e-9 .. 1e9, or 0 for no limit");
    if (const int kind = static_cast<int>(joint.kind);
        kind < 0 || kind >= std::ssize(kJointKindNames))
      refuse(what + ": its kind is " + std::to_string(kind), "0 is revolute, 1 prismatic");
    if (joint.continuous && joint.kind == Joint::Kind::prismatic)
      refuse(what + ": it is prismatic and continuous", "only what is revolute turns on and on");
  }
  for (const auto& [name, q] : robot.states) {
    if (q.size() != robot.size() || !q.allFinite())
      refuse("state \"" + name + "\" has not a number for each joint", "give it one for each");
  }
  if (!finite(from_eigen(robot.tip).position)) refuse("the tip is out of range", "within 1000 m");
  check_rotation(robot.tip, "the tip");
  check_links(robot, corners);
}

/// Where the body is that moves with each joint.
std::vector<Placement> place(const Robot& robot, const JointRef& q) {
  validate_but_corners(robot);
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
  refuse_other_kinds(text, file, {FileKind::urdf, FileKind::other_xml, FileKind::arm},
                     "give the robot's URDF or its description in JSON; an SRDF goes to --srdf");
  const auto first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const char begins = first == std::string_view::npos ? '\0' : text[first];
  const bool named = has_ending(file, ".urdf") || has_ending(file, ".xml");
  if (begins == '<' || (named && begins != '{')) return parse_urdf(text, file, chain);
  Robot robot = parse_short(text, file);
  const std::pair<const char*, bool> given[] = {{"base", !chain.base.empty()},
                                                {"tip", !chain.tip.empty()},
                                                {"set_joints", !chain.set_joints.empty()},
                                                {"srdf", !chain.srdf.empty()},
                                                {"joint_limits", !chain.joint_limits.empty()},
                                                {"allow_contact", !chain.allow_contact.empty()},
                                                {"packages", !chain.packages.empty()},
                                                {"use_visual", chain.use_visual},
                                                {"bodiless", chain.bodiless}};
  for (const auto& [name, is_given] : given)
    if (is_given)
      refuse(std::string(name) + " is given, for URDF robots, but " + file + " is no URDF file",
             "leave it out; what it says stands in the file");
  return robot;
}

Robot read_robot(const std::string& path, const Chain& chain) {
  constexpr std::int64_t kMostBytes = 16 << 20;
  return parse_robot(read_text(path, kMostBytes), path, chain);
}

void validate(const Robot& robot) { check(robot, Corners::looked_at); }
void validate_but_corners(const Robot& robot) { check(robot, Corners::left_out); }

void validate(const Scene& scene) {
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    check_solid(scene.obstacles[i], "obstacle " + std::to_string(i + 1), Corners::looked_at);
}

Eigen::Vector3d tip_position(const Robot& robot, const JointRef& q) {
  return place(robot, q).back() * from_eigen(robot.tip).position;
}

Pose tip_pose(const Robot& robot, const JointRef& q) {
  return to_eigen(place(robot, q).back() * from_eigen(robot.tip));
}

std::vector<Link> place_links(const Robot& robot, const JointRef& q) {
  const std::vector<Placement> poses = place(robot, q);
  std::vector<Link> placed = robot.links;
  for (Link& link : placed) {
    if (link.body == 0) continue;
    for (Solid& solid : link.solids)
      solid.pose = to_eigen(poses[link.body - 1] * from_eigen(solid.pose));
  }
  return placed;
}

}  // namespace lasius::arm
