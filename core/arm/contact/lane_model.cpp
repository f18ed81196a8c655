#include "core/arm/contact/lane_model.h"

#include <algorithm>
#include <cmath>

namespace lasius::arm {
namespace {

std::array<float, 3> floats(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
std::array<float, 9> floats(const Rotation& r) {
  std::array<float, 9> f;
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = static_cast<float>(r[i]);
  return f;
}

/// A half turn and a quarter about the axis have all that other turns are made of (Rodrigues).
kernels::LaneJoint lane_joint(const Joint& joint) {
  const Placement frame = from_eigen(joint.frame);
  const Vec3 a = joint.axis;
  const Rotation along{a.x * a.x, a.x * a.y, a.x * a.z, a.y * a.x, a.y * a.y,
                       a.y * a.z, a.z * a.x, a.z * a.y, a.z * a.z};
  Rotation across = kNoRotation;
  for (std::size_t i = 0; i < along.size(); ++i) across[i] -= along[i];
  const bool slides = joint.kind == Joint::Kind::prismatic;
  return {.fixed = floats(slides ? frame.rotation : frame.rotation * along),
          .with_cosine = floats(frame.rotation * across),
          .with_sine = floats(frame.rotation * Rotation{0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0}),
          .position = floats(frame.position),
          .axis = floats(a),
          .along = floats(frame.rotation * a),
          .slides = slides,
          .length = length(frame.position) +
                    (slides ? std::max(std::abs(joint.low), std::abs(joint.high)) : 0)};
}

/// A shape and, where it has parts, few of those that together are all of it: the largest opened.
std::vector<const Shape*> nodes_of(const Shape& whole) {
  constexpr double kSmall = 0.03;  // metres
  std::vector<const Shape*> nodes{&whole};
  while (std::ssize(nodes) + 1 < kernels::kMostOuterBalls) {
    const Shape* largest = nullptr;
    for (const Shape* const node : nodes) {
      if (node->exact || (node == &whole && nodes.size() > 1)) continue;
      if (largest == nullptr || node->radius > largest->radius) largest = node;
    }
    if (largest == nullptr || (largest->radius < kSmall && nodes.size() > 1)) break;
    const Shape::Parts& parts = parts_of(*largest);
    if (largest != &whole) std::erase(nodes, largest);
    nodes.insert(nodes.end(), parts.begin(), parts.end());
  }
  return nodes;
}

kernels::LaneBall lane_ball(Vec3 centre, double radius, double far = 0, bool hollow = false) {
  return {floats(centre), static_cast<float>(radius), static_cast<float>(far), hollow};
}

}  // namespace

LaneModel::LaneModel(const Robot& from, const std::vector<const Shape*>& bodies,
                     const std::vector<std::vector<InnerBall>>& inner) {
  double extent = 0;
  for (int k = 0; k < from.size(); ++k) {
    robot.joints.push_back(lane_joint(from.joints[k]));
    size += robot.joints.back().length;
    const Shape* const whole = bodies[k + 1];
    nodes.push_back(whole == nullptr ? std::vector<const Shape*>() : nodes_of(*whole));
    kernels::LaneBody& body = robot.bodies.emplace_back();
    for (const Shape* const node : nodes.back()) {
      body.outer.push_back(lane_ball(node->centre, node->radius, node->far));
      extent = std::max(extent, node->far);
    }
    for (const InnerBall& ball : inner[k + 1])
      body.inner.push_back(lane_ball(ball.centre, ball.radius, 0, ball.hollow));
  }
  size += extent;
}

kernels::LaneObstacle LaneModel::obstacle(const Shape& shape) const {
  kernels::LaneObstacle o{.rotation = floats(shape.at.rotation),
                          .position = floats(shape.at.position),
                          .half = floats(shape.half),
                          .round = static_cast<float>(shape.round),
                          .radius = static_cast<float>(shape.radius),
                          .margin = 0,
                          .cylinder = shape.kind != Shape::Kind::box,
                          .solid = shape.exact && shape.kind != Shape::Kind::triangle};
  if (shape.kind == Shape::Kind::segment) {
    const Vec3 way = shape.corner[1] - shape.corner[0];
    const double long_ = length(way);
    const Vec3 z = long_ > 0 ? (1 / long_) * way : Vec3{0, 0, 1};
    const Vec3 off = cross(std::abs(z.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, z);
    const Vec3 x = (1 / length(off)) * off, y = cross(z, x);
    o.rotation = floats(Rotation{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z});
    o.position = floats(0.5 * (shape.corner[0] + shape.corner[1]));
    o.half = floats(Vec3{0, 0, 0.5 * long_});
  } else if (!o.solid) {  // the ball around it
    o.position = floats(shape.centre);
    o.half = {};
    o.round = o.radius;
  }
  constexpr double kFloat = 1e-6;  // a few of its roundings, each joint
  const double far = size + length(shape.centre) + shape.radius;
  o.margin = static_cast<float>(kFloat * static_cast<double>(robot.joints.size() + 4) * far);
  return o;
}

}  // namespace lasius::arm
