#include "core/arm/urdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/arm/enclose.h"
#include "core/arm/kinematics.h"
#include "core/arm/mesh_file.h"
#include "core/arm/urdf_file.h"
#include "core/arm/vec3.h"
#include "core/base/did_you_mean.h"
#include "core/base/number_text.h"
#include "core/base/output.h"
#include "lasius/arm_sensor.h"
#include "lasius/error.h"

namespace lasius::arm {
namespace {

using LinkPtr = urdf::LinkConstSharedPtr;

/// urdfdom computes rotations by the C library: rounded, seldom others on another machine.
double settle(double v) { return std::round(v * 0x1p40) * 0x1p-40; }

Vec3 vec(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Placement placement(const urdf::Pose& p) {
  const urdf::Rotation& r = p.rotation;
  const double x = r.x, y = r.y, z = r.z, w = r.w;
  Placement result{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                    2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)},
                   vec(p.position)};
  for (double& entry : result.rotation) entry = settle(entry);
  return result;
}

LinkPtr find_link(const urdf::ModelInterface& model, const std::string& name,
                  const std::string& what) {
  if (LinkPtr link = model.getLink(name)) return link;
  std::vector<std::string_view> names;
  for (const auto& [known, link] : model.links_) names.push_back(known);
  throw Error(ErrorCode::invalid_parameter, "the robot has no " + what + " link \"" + name + "\"",
              did_you_mean(name, names));
}

LinkPtr only_leaf(const urdf::ModelInterface& model) {
  LinkPtr leaf;
  std::string names;
  int count = 0;
  for (const auto& [name, link] : model.links_) {
    if (!link->child_links.empty()) continue;
    leaf = link;
    names += (count++ > 0 ? ", " : "") + name;
  }
  if (count == 1) return leaf;
  throw Error(ErrorCode::invalid_parameter, "the robot ends in several links: " + names,
              "choose one of them as the tip");
}

/// Geometry that is less than it should be would not collide.
[[noreturn]] void refuse_geometry(const std::string& link, const UrdfFile& source) {
  broken(source.link(link), "the collision geometry of link \"" + link + "\" cannot be read",
         "give a box, sphere, cylinder or mesh whose sizes are numbers above 0");
}

std::vector<Capsule> enclose(const urdf::Geometry& shape, const Placement& at,
                             const std::string& link, const UrdfFile& source) {
  const auto check_sizes = [&](std::initializer_list<double> sizes) {
    for (const double size : sizes) {
      if (!(size > 0 && std::isfinite(size))) refuse_geometry(link, source);
    }
  };
  switch (shape.type) {
    case urdf::Geometry::SPHERE: {
      const auto& sphere = static_cast<const urdf::Sphere&>(shape);
      check_sizes({sphere.radius});
      return {{at.position, at.position, sphere.radius}};
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(shape);
      check_sizes({cylinder.radius, cylinder.length});
      const Vec3 half{0, 0, 0.5 * cylinder.length};
      return {{at * (-1.0 * half), at * half, cylinder.radius}};
    }
    case urdf::Geometry::BOX: {
      const auto& box = static_cast<const urdf::Box&>(shape);
      check_sizes({box.dim.x, box.dim.y, box.dim.z});
      return enclose_box(at, vec(box.dim));
    }
    default: {
      const auto& mesh = static_cast<const urdf::Mesh&>(shape);
      if (mesh.filename.find("://") != std::string::npos || !has_ending(mesh.filename, ".stl")) {
        unsupported(source.link(link), "the mesh \"" + mesh.filename + "\" cannot be found or read",
                    "name an .stl file by its path beside the URDF file");
      }
      for (const double s : {mesh.scale.x, mesh.scale.y, mesh.scale.z}) {
        if (s != 0 && std::isfinite(s)) continue;
        broken(source.link(link),
               "the mesh \"" + mesh.filename + "\" is scaled by " + number_text(s),
               "scale it by other numbers than 0; negative ones mirror it");
      }
      const Triangles triangles = read_stl(mesh_path(source.name(), mesh.filename));
      Vec3 low = triangles[0][0], high = low;
      for (const auto& triangle : triangles) {
        for (const Vec3 c : triangle) {
          low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
          high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
        }
      }
      const auto scaled = [&](Vec3 v) {
        return Vec3{v.x * mesh.scale.x, v.y * mesh.scale.y, v.z * mesh.scale.z};
      };
      low = scaled(low);
      high = scaled(high);
      const Vec3 size = high - low;
      return enclose_box(at * Placement{kNoRotation, 0.5 * (low + high)},
                         {std::abs(size.x), std::abs(size.y), std::abs(size.z)});
    }
  }
}

/// Adds a link's collision geometry to the robot's last body so far, `at` its pose there.
void add_geometry(const urdf::Link& link, const Placement& at, const UrdfFile& source,
                  Robot& robot) {
  auto& to = robot.joints.empty() ? robot.base : robot.joints.back().capsules;
  for (const auto& collision : link.collision_array) {
    if (collision == nullptr || collision->geometry == nullptr) refuse_geometry(link.name, source);
    for (const Capsule& c :
         enclose(*collision->geometry, at * placement(collision->origin), link.name, source)) {
      to.push_back(c);
    }
    if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(collision->geometry.get()))
      robot.meshes.push_back(mesh_path(source.name(), mesh->filename));
  }
}

Joint moving_joint(const urdf::Joint& joint, const Placement& at, const UrdfFile& source) {
  Joint made;
  made.name = joint.name;
  made.frame = to_eigen(at);
  const Vec3 axis = vec(joint.axis);
  if (!(length(axis) > 1e-9)) {
    broken(source.joint(joint.name), "joint \"" + joint.name + "\" has an axis of no length",
           "as in xyz=\"0 0 1\"");
  }
  made.axis = (1 / length(axis)) * axis;
  made.kind = joint.type == urdf::Joint::PRISMATIC ? Joint::Kind::prismatic : Joint::Kind::revolute;
  constexpr double kTurn = 6.283185307179586;
  if (joint.type == urdf::Joint::CONTINUOUS) {
    made.low = -kTurn;
    made.high = kTurn;
  } else if (joint.limits != nullptr) {
    made.low = joint.limits->lower;
    made.high = joint.limits->upper;
  }
  if (!(made.low < made.high)) {
    broken(source.joint(joint.name),
           "joint \"" + joint.name + "\" has limits that leave it no room",
           "give it a <limit> with lower below upper");
  }
  const double velocity = joint.limits != nullptr ? joint.limits->velocity : 0;
  if (!(velocity >= 0)) {
    broken(source.joint(joint.name),
           "joint \"" + joint.name + "\" has the velocity limit " + number_text(velocity),
           "give it one above 0, or 0 for 1 a second");
  }
  made.velocity = velocity > 0 ? velocity : 1;  // files that know none say 0
  made.acceleration = 4 * made.velocity;
  return made;
}

/// Pairs of bodies that touch where all joints are at 0, or as near to it as they get: by their
/// making, or because their capsules are wider than they are.
void let_touch_what_touches(Robot& robot) {
  JointVector q(robot.size());
  for (int j = 0; j < robot.size(); ++j) {
    q[j] = std::clamp(0.0, robot.joints[j].low, robot.joints[j].high);
  }
  for (int b = 2; b <= robot.size(); ++b) {
    for (int a = 0; a + 1 < b; ++a) {
      Robot pair = robot;
      pair.may_touch.clear();
      for (int body = 0; body <= robot.size(); ++body) {
        if (body == a || body == b) continue;
        (body == 0 ? pair.base : pair.joints[body - 1].capsules).clear();
      }
      if (!SceneSensor(pair, {}).position_free(q)) robot.may_touch.emplace_back(a, b);
    }
  }
}

}  // namespace

Robot parse_urdf(std::string_view text, const std::string& file, const Chain& chain) {
  const UrdfFile source(text, file);
  const urdf::ModelInterface& model = source.model();
  const LinkPtr base = chain.base.empty() ? model.getRoot() : find_link(model, chain.base, "base");
  const LinkPtr tip = chain.tip.empty() ? only_leaf(model) : find_link(model, chain.tip, "tip");

  std::vector<LinkPtr> links;  // from the tip down to the base
  for (LinkPtr link = tip; link != nullptr && link != base; link = link->getParent()) {
    links.push_back(link);
  }
  const LinkPtr last = links.empty() ? tip : links.back()->getParent();
  if (last != base) {
    throw Error(ErrorCode::invalid_parameter,
                "link \"" + tip->name + "\" does not hang on \"" + base->name + "\"",
                "choose a base between the root and the tip");
  }
  std::reverse(links.begin(), links.end());

  Robot robot;
  robot.name = model.getName();
  Placement at;  // of the link in the body that it moves with
  add_geometry(*base, at, source, robot);
  for (const LinkPtr& link : links) {
    const urdf::Joint& joint = *link->parent_joint;
    at = at * placement(joint.parent_to_joint_origin_transform);
    if (joint.mimic != nullptr) {
      unsupported(source.joint(joint.name), "joint \"" + joint.name + "\" follows another one",
                  "joints that mimic are not supported");
    }
    switch (joint.type) {
      case urdf::Joint::FIXED:
        break;
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
      case urdf::Joint::PRISMATIC:
        robot.joints.push_back(moving_joint(joint, at, source));
        at = {};
        break;
      default:
        unsupported(source.joint(joint.name),
                    "joint \"" + joint.name + "\" is neither fixed nor turns or slides",
                    "planar and floating joints are not supported");
    }
    if (robot.size() > Robot::kMaxJoints) {
      unsupported(source.joint(joint.name), "the chain has too many joints",
                  "at most " + std::to_string(Robot::kMaxJoints) + " are supported");
    }
    add_geometry(*link, at, source, robot);
  }
  if (robot.joints.empty()) {
    throw Error(ErrorCode::invalid_parameter,
                "no joint moves between \"" + base->name + "\" and \"" + tip->name + "\"",
                "choose another base or tip");
  }
  robot.tip = at.position;
  try {
    validate(robot);
  } catch (const Error& error) {
    broken(source.whole(), error.problem(), error.remedy());
  }
  let_touch_what_touches(robot);
  return robot;
}

}  // namespace lasius::arm
