#include "core/arm/robot/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lasius::arm {

Solid capsule(Vec3 from, Vec3 way, double radius) {
  Solid solid;
  solid.shape = Solid::Shape::capsule;
  solid.pose.translation() = Eigen::Vector3d(from);
  solid.size = way;
  solid.radius = radius;
  return solid;
}

double extent(const Solid& solid) {
  const Placement at = from_eigen(solid.pose);
  switch (solid.shape) {
    case Solid::Shape::box:
      return length(at.position) + 0.5 * length(solid.size);
    case Solid::Shape::sphere:
      return length(at.position) + solid.radius;
    case Solid::Shape::cylinder:
      return length(at.position) +
             std::sqrt(solid.radius * solid.radius + 0.25 * solid.length * solid.length);
    case Solid::Shape::capsule:
      return std::max(length(at.position), length(at * solid.size)) + solid.radius;
    case Solid::Shape::mesh:
      break;
  }
  double far = 0;
  if (solid.triangles != nullptr) {
    for (const auto& triangle : *solid.triangles) {
      for (const Vec3 corner : triangle) far = std::max(far, length(at * corner));
    }
  }
  return far;
}

std::vector<LinkPair> link_pairs(const Robot& robot) {
  const auto allowed = [&](int a, int b) {
    return std::ranges::any_of(robot.may_touch, [&](const auto& pair) {
      return pair == std::pair(a, b) || pair == std::pair(b, a);
    });
  };
  std::vector<LinkPair> pairs;
  const int count = static_cast<int>(robot.links.size());
  for (int b = 0; b < count; ++b) {
    for (int a = 0; a < b; ++a) {
      const Link &first = robot.links[a], &second = robot.links[b];
      if (first.solids.empty() || second.solids.empty()) continue;
      const auto check = first.body == second.body                 ? LinkPair::Check::rigid
                         : first.parent == b || second.parent == a ? LinkPair::Check::neighbours
                         : allowed(a, b)                           ? LinkPair::Check::allowed
                                                                   : LinkPair::Check::yes;
      pairs.push_back({a, b, check});
    }
  }
  return pairs;
}

std::string link_name(const Robot& robot, int link) {
  const Link& of = robot.links[link];
  if (!of.name.empty()) return "link \"" + of.name + '"';
  if (of.body == 0) return "the base";
  std::string number = "link " + std::to_string(of.body);
  if (of.body > robot.size() || robot.joints[of.body - 1].name.empty()) return number;
  return number + " (after " + robot.joints[of.body - 1].name + ")";
}

}  // namespace lasius::arm
