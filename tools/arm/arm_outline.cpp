#include "tools/arm/arm_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lasius::tool {
namespace {

using Eigen::Vector3d;

double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::vector<Vector3d> outline(const arm::Solid& o) {
  std::vector<Vector3d> points;
  const auto add = [&](const Vector3d& p) { points.emplace_back(o.pose * p); };
  constexpr int kParts = 32;
  const auto angle = [](int i) { return 2 * std::numbers::pi * i / kParts; };
  const auto add_circles = [&](const Vector3d& middle) {
    for (int i = 0; i < kParts; ++i) {
      const double c = o.radius * std::cos(angle(i)), s = o.radius * std::sin(angle(i));
      for (const Vector3d& p : {Vector3d(c, s, 0), Vector3d(c, 0, s), Vector3d(0, c, s)})
        points.emplace_back(middle + p);
    }
  };
  switch (o.shape) {
    case arm::Solid::Shape::box:
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          for (const double z : {-0.5, 0.5}) add({x * o.size[0], y * o.size[1], z * o.size[2]});
      break;
    case arm::Solid::Shape::sphere:
      add_circles(o.pose.translation());
      break;
    case arm::Solid::Shape::cylinder:
      for (int i = 0; i < kParts; ++i)
        for (const double z : {-0.5 * o.length, 0.5 * o.length})
          add({o.radius * std::cos(angle(i)), o.radius * std::sin(angle(i)), z});
      break;
    case arm::Solid::Shape::capsule:
      for (const Vector3d& end : {Vector3d(0, 0, 0), Vector3d(o.size)}) add_circles(o.pose * end);
      break;
    case arm::Solid::Shape::mesh:
      if (o.triangles == nullptr) break;
      for (const auto& triangle : *o.triangles)
        for (const Vector3d& corner : triangle) add(corner);
      break;
  }
  return points;
}

std::vector<arm::Pose> body_poses(const arm::Robot& robot, const arm::JointVector& q) {
  std::vector<arm::Pose> poses{arm::Pose::Identity()};
  for (int i = 0; i < robot.size(); ++i) {
    const arm::Joint& joint = robot.joints[static_cast<std::size_t>(i)];
    arm::Pose at = poses.back() * joint.frame;
    if (joint.kind == arm::Joint::Kind::revolute)
      at.rotate(Eigen::AngleAxisd(q[i], joint.axis));
    else
      at.translate(Vector3d(q[i] * joint.axis));
    poses.push_back(at);
  }
  return poses;
}

std::vector<Point> hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Point> chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = chain.size();
    for (const Point p : points) {
      while (chain.size() >= base + 2 && turn(chain[chain.size() - 2], chain.back(), p) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

}  // namespace lasius::tool
