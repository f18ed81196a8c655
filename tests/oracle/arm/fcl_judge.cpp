#include "tests/oracle/arm/fcl_judge.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <exception>
#include <kdl/frames.hpp>
#include <limits>

namespace lasius::oracle {
namespace {

using Shape = std::shared_ptr<fcl::CollisionGeometryd>;
using arm::Solid;

KDL::Vector vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

fcl::Transform3d transform(const KDL::Frame& frame) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.linear()(i, j) = frame.M(i, j);
    t.translation()(i) = frame.p(i);
  }
  return t;
}

/// FCL takes a triangle without area for touching everything: its corners are moved by a nanometre.
std::array<Eigen::Vector3d, 3> with_area(const std::array<Eigen::Vector3d, 3>& triangle) {
  constexpr double kTolerance = 1e-9;
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d u = b - a, v = c - a;
  const double size = std::max(u.norm(), v.norm());
  if (u.cross(v).norm() > 1e-12 * size * size) return triangle;
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();
  if (size > kTolerance) along = (u.norm() < size ? v : u) / size;
  const Eigen::Vector3d across = along.unitOrthogonal();
  return {a, b + kTolerance * across, c + kTolerance * along.cross(across)};
}

Shape mesh_of(const arm::Triangles& triangles) {
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  for (const auto& triangle : triangles) {
    const auto [a, b, c] = with_area(triangle);
    mesh->addTriangle(a, b, c);
  }
  mesh->endModel();
  return mesh;
}

/// As FCL has it: what is long along z, about its middle.
Shape shape_of(const Solid& s, fcl::Transform3d& at) {
  switch (s.shape) {
    case Solid::Shape::box:
      return std::make_shared<fcl::Boxd>(s.size);
    case Solid::Shape::sphere:
      return std::make_shared<fcl::Sphered>(s.radius);
    case Solid::Shape::cylinder:
      return std::make_shared<fcl::Cylinderd>(s.radius, s.length);
    case Solid::Shape::capsule:
      at.translation() = at * (0.5 * s.size);
      at.linear() =
          at.linear() *
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), s.size).toRotationMatrix();
      return std::make_shared<fcl::Capsuled>(s.radius, s.size.norm());
    case Solid::Shape::mesh:
      break;
  }
  return mesh_of(*s.triangles);
}

/// FCL has no mesh without triangles.
bool is_nothing(const Solid& s) {
  return s.shape == Solid::Shape::mesh && (s.triangles == nullptr || s.triangles->empty());
}

bool may_touch(const arm::Robot& robot, int a, int b) {
  const arm::Link &first = robot.links[a], &second = robot.links[b];
  if (first.body == second.body || first.parent == b || second.parent == a) return true;
  return std::ranges::any_of(robot.may_touch, [&](const auto& pair) {
    return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
  });
}

bool collide(const fcl::CollisionGeometryd* a, const fcl::Transform3d& at,
             const fcl::CollisionGeometryd* b, const fcl::Transform3d& there) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  try {
    fcl::collide(a, at, b, there, request, result);
  } catch (const std::exception&) {
    return true;
  }
  return result.isCollision();
}

/// By balls around both, no more than the distance.
double balls_apart(const fcl::CollisionGeometryd* a, const fcl::Transform3d& at,
                   const fcl::CollisionGeometryd* b, const fcl::Transform3d& there) {
  return (at * a->aabb_center - there * b->aabb_center).norm() - a->aabb_radius - b->aabb_radius;
}

}  // namespace

FclJudge::FclJudge(const arm::Robot& robot, const arm::Scene& scene) : tip_(robot.tip.matrix()) {
  for (const arm::Joint& joint : robot.joints) {
    const Eigen::Matrix3d r = joint.frame.linear();
    const KDL::Rotation rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0),
                                 r(2, 1), r(2, 2));
    // A fixed segment to the joint's frame, then the joint itself.
    chain_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None),
                                   KDL::Frame(rotation, vec(joint.frame.translation()))));
    const auto type =
        joint.kind == arm::Joint::Kind::prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    chain_.addSegment(KDL::Segment(KDL::Joint(KDL::Vector::Zero(), vec(joint.axis), type)));
  }
  const auto add = [](std::vector<Part>& parts, const Solid& solid, int link, int body) {
    if (is_nothing(solid)) return;
    Part part{nullptr, Pose(solid.pose.matrix()), link, body};
    part.shape = shape_of(solid, part.at);
    part.shape->computeLocalAABB();
    parts.push_back(std::move(part));
  };
  for (const arm::Obstacle& o : scene.obstacles) add(obstacles_, o, -1, 0);
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    for (const Solid& solid : robot.links[i].solids)
      add(parts_, solid, static_cast<int>(i), robot.links[i].body);
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!may_touch(robot, parts_[i].link, parts_[k].link)) pairs_.emplace_back(i, k);
}

std::vector<FclJudge::Pose> FclJudge::bodies(const arm::JointRef& q) const {
  std::vector<Pose> all{Pose::Identity()};
  KDL::Frame at;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const auto segment = static_cast<unsigned>(2 * j);
    at = at * chain_.getSegment(segment).pose(0) * chain_.getSegment(segment + 1).pose(q[j]);
    all.push_back(transform(at));
  }
  return all;
}

template <class Visit>
bool FclJudge::any_pair(const arm::JointRef& q, const Visit& visit) const {
  const std::vector<Pose> at = bodies(q);
  std::vector<Pose> placed;
  for (const Part& part : parts_)
    placed.push_back(at[static_cast<std::size_t>(part.body)] * part.at);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].body == 0) continue;
    for (const Part& o : obstacles_)
      if (visit(parts_[i].shape.get(), placed[i], o.shape.get(), o.at)) return true;
  }
  return std::ranges::any_of(pairs_, [&](const auto& pair) {
    return visit(parts_[pair.first].shape.get(), placed[pair.first],
                 parts_[pair.second].shape.get(), placed[pair.second]);
  });
}

bool FclJudge::touches(const arm::JointRef& q) const {
  return any_pair(q, [](const auto* a, const Pose& at, const auto* b, const Pose& there) {
    return balls_apart(a, at, b, there) <= 0 && collide(a, at, b, there);
  });
}

double FclJudge::distance(const arm::JointRef& q) const {
  double least = std::numeric_limits<double>::infinity();
  any_pair(q, [&](const auto* a, const Pose& at, const auto* b, const Pose& there) {
    if (balls_apart(a, at, b, there) >= least) return false;
    if (collide(a, at, b, there)) {
      least = 0;
      return true;
    }
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    try {
      least = std::min(least, std::max(0.0, fcl::distance(a, at, b, there, request, result)));
    } catch (const std::exception&) {
      least = 0;
    }
    return least == 0;
  });
  return least;
}

Eigen::Vector3d FclJudge::tip(const arm::JointRef& q) const {
  return (bodies(q).back() * tip_).translation();
}

}  // namespace lasius::oracle
