// The independent check: KDL places the links, FCL measures.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include <algorithm>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/frames.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/arm/kinematics.h"
#include "core/arm/vec3.h"
#include "lasius/arm_trajectory.h"
#include "lasius/error.h"

namespace fcl {

// As <fcl/narrowphase/collision.h> and distance.h declare them. The library holds both for doubles;
// those headers bring all that they are made of, which takes long to compile.
template <class S>
std::size_t collide(const CollisionGeometry<S>*, const Transform3<S>&, const CollisionGeometry<S>*,
                    const Transform3<S>&, const CollisionRequest<S>&, CollisionResult<S>&);
extern template FCL_EXPORT std::size_t collide(const CollisionGeometryd*, const Transform3d&,
                                               const CollisionGeometryd*, const Transform3d&,
                                               const CollisionRequestd&, CollisionResultd&);
template <class S>
S distance(const CollisionGeometry<S>*, const Transform3<S>&, const CollisionGeometry<S>*,
           const Transform3<S>&, const DistanceRequest<S>&, DistanceResult<S>&);
extern template FCL_EXPORT double distance(const CollisionGeometryd*, const Transform3d&,
                                           const CollisionGeometryd*, const Transform3d&,
                                           const DistanceRequestd&, DistanceResultd&);

}  // namespace fcl

namespace lasius::arm {
namespace {

using Shape = std::shared_ptr<fcl::CollisionGeometryd>;

KDL::Vector vec(Vec3 v) { return {v.x, v.y, v.z}; }

KDL::Chain make_chain(const Robot& robot) {
  KDL::Chain chain;
  for (const Joint& joint : robot.joints) {
    const auto [r, origin] = from_eigen(joint.frame);
    const KDL::Rotation rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
    // A fixed segment to the joint's frame, then the joint itself.
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame(rotation, vec(origin))));
    const auto type =
        joint.kind == Joint::Kind::prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Vector::Zero(), vec(joint.axis), type)));
  }
  return chain;
}

fcl::Transform3d transform(const KDL::Frame& frame) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.linear()(i, j) = frame.M(i, j);
    t.translation()(i) = frame.p(i);
  }
  return t;
}

struct Placed {
  Shape shape;
  fcl::Transform3d at;
};

Placed place(const Obstacle& o) {
  const fcl::Transform3d at(o.pose.matrix());
  switch (o.shape) {
    case Obstacle::Shape::box:
      return {std::make_shared<fcl::Boxd>(o.size), at};
    case Obstacle::Shape::sphere:
      return {std::make_shared<fcl::Sphered>(o.radius), at};
    case Obstacle::Shape::cylinder:
      return {std::make_shared<fcl::Cylinderd>(o.radius, o.length), at};
    case Obstacle::Shape::mesh:
      break;
  }
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  for (const auto& [a, b, c] : o.triangles) mesh->addTriangle(a, b, c);
  mesh->endModel();
  return {mesh, at};
}

/// The shortest turn of z to a direction. But for directions next to -z it is Eigen's
/// FromTwoVectors to the bit, whose singular value decomposition for these takes long to compile.
Eigen::Quaterniond turn_of_z(const Eigen::Vector3d& to) {
  const Eigen::Vector3d v = to.normalized();
  if (v.z() < -1 + 1e-12) {
    const double across = std::hypot(v.x(), v.y());
    if (across == 0) return {0, -1, 0, 0};
    return {0.5 * across, -v.y() / across, v.x() / across, 0};
  }
  const double s = std::sqrt((1 + v.z()) * 2), inverse = 1 / s;
  return {s * 0.5, -v.y() * inverse, v.x() * inverse, 0};
}

/// A capsule in its body, as FCL has it: along z, about its middle.
struct Link {
  Shape shape;
  fcl::Transform3d in_body;
  int body;

  Link(const Capsule& c, int b) : body(b) {
    const Eigen::Vector3d d = c.to - c.from;
    const double size = d.norm();
    shape = std::make_shared<fcl::Capsuled>(c.radius, size);
    in_body = fcl::Transform3d::Identity();
    in_body.translation() = 0.5 * (c.from + c.to);
    if (size > 0) in_body.linear() = turn_of_z(d).toRotationMatrix();
  }
};

/// 0 where they touch.
double distance(const Placed& a, const Placed& b) {
  fcl::CollisionRequestd touch;
  fcl::CollisionResultd touched;
  fcl::collide(a.shape.get(), a.at, b.shape.get(), b.at, touch, touched);
  if (touched.isCollision()) return 0;
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  return fcl::distance(a.shape.get(), a.at, b.shape.get(), b.at, request, result);
}

bool may_touch(const Robot& robot, int a, int b) {
  if (std::abs(a - b) <= 1) return true;
  return std::any_of(robot.may_touch.begin(), robot.may_touch.end(), [&](const auto& pair) {
    return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
  });
}

bool breaks_limit(const Robot& robot, const Trajectory::State& state) {
  constexpr double kHair = 1e-9;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (state.q[j] < joint.low - kHair || state.q[j] > joint.high + kHair ||
        std::abs(state.dq[j]) > joint.velocity * (1 + kHair) ||
        std::abs(state.ddq[j]) > joint.acceleration * (1 + kHair)) {
      return true;
    }
  }
  return false;
}

void check(const Robot& robot, const Scene& scene, const Trajectory& trajectory, int samples) {
  validate(robot);
  validate(scene);
  if (trajectory.empty()) {
    throw Error(ErrorCode::invalid_parameter, "the trajectory is empty", "give it a knot");
  }
  for (const Trajectory::Knot& knot : trajectory.knots()) {
    check_values(robot, as_span(knot.q));
    check_values(robot, as_span(knot.ddq));
  }
  if (samples < 1) {
    throw Error(ErrorCode::invalid_parameter, "samples is " + std::to_string(samples),
                "it must be at least 1");
  }
}

}  // namespace

Recheck recheck(const Robot& robot, const Scene& scene, const Trajectory& trajectory, int samples) {
  check(robot, scene, trajectory, samples);
  const KDL::Chain chain = make_chain(robot);
  std::vector<Placed> obstacles;
  for (const Obstacle& o : scene.obstacles) obstacles.push_back(place(o));
  std::vector<Link> links;
  for (int b = 0; b <= robot.size(); ++b) {
    for (const Capsule& c : b == 0 ? robot.base : robot.joints[b - 1].capsules) {
      links.emplace_back(c, b);
    }
  }

  Recheck found{.samples = samples, .nearest = std::numeric_limits<double>::infinity()};
  for (int s = 0; s < samples; ++s) {
    const double share = samples > 1 ? static_cast<double>(s) / (samples - 1) : 0;
    const Trajectory::State state = trajectory.at(share * trajectory.duration());
    std::vector<fcl::Transform3d> bodies{fcl::Transform3d::Identity()};
    KDL::Frame at;
    for (int j = 0; j < robot.size(); ++j) {
      at = at * chain.getSegment(2 * j).pose(0) * chain.getSegment(2 * j + 1).pose(state.q[j]);
      bodies.push_back(transform(at));
    }
    const KDL::Vector tip = at * vec(robot.tip);
    found.tip_error = std::max(found.tip_error,
                               distance(tip_position(robot, state.q), {tip.x(), tip.y(), tip.z()}));

    std::vector<Placed> placed;
    placed.reserve(links.size());
    for (const Link& link : links) placed.push_back({link.shape, bodies[link.body] * link.in_body});
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (links[i].body > 0) {
        for (const Placed& o : obstacles) nearest = std::min(nearest, distance(placed[i], o));
      }
      for (std::size_t k = 0; k < i; ++k) {
        if (may_touch(robot, links[i].body, links[k].body)) continue;
        nearest = std::min(nearest, distance(placed[i], placed[k]));
      }
    }
    found.nearest = std::min(found.nearest, nearest);
    found.contacts += nearest <= 0;
    found.limits += breaks_limit(robot, state);
  }
  return found;
}

}  // namespace lasius::arm
