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
#include <array>
#include <cmath>
#include <exception>
#include <kdl/chain.hpp>
#include <kdl/frames.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "core/arm/robot/kinematics.h"
#include "core/arm/robot/vec3.h"
#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "lasius/arm_trajectory.h"

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

/// A solid as FCL has it: what is long along z, about its middle.
Placed place_shape(const Solid& s) {
  fcl::Transform3d at(s.pose.matrix());
  switch (s.shape) {
    case Solid::Shape::box:
      return {std::make_shared<fcl::Boxd>(s.size), at};
    case Solid::Shape::sphere:
      return {std::make_shared<fcl::Sphered>(s.radius), at};
    case Solid::Shape::cylinder:
      return {std::make_shared<fcl::Cylinderd>(s.radius, s.length), at};
    case Solid::Shape::capsule: {
      const double size = s.size.norm();
      at.translation() = at * (0.5 * s.size);
      if (size > 0) at.linear() = at.linear() * turn_of_z(s.size).toRotationMatrix();
      return {std::make_shared<fcl::Capsuled>(s.radius, size), at};
    }
    case Solid::Shape::mesh:
      break;
  }
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  for (const auto& triangle : *s.triangles) {
    const auto [a, b, c] = with_area(triangle);
    mesh->addTriangle(a, b, c);
  }
  mesh->endModel();
  return {mesh, at};
}

Placed place(const Solid& s) {
  Placed placed = place_shape(s);
  placed.shape->computeLocalAABB();
  return placed;
}

/// In the frame of the body that its link moves with.
struct Part {
  Placed solid;
  int link, body;
};

/// 0 where they touch, and where FCL finds no answer.
double distance(const Placed& a, const Placed& b) {
  fcl::CollisionRequestd touch;
  fcl::CollisionResultd touched;
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  try {
    fcl::collide(a.shape.get(), a.at, b.shape.get(), b.at, touch, touched);
    if (touched.isCollision()) return 0;
    return std::max(0.0, fcl::distance(a.shape.get(), a.at, b.shape.get(), b.at, request, result));
  } catch (const std::exception&) {
    return 0;
  }
}

/// No more than the distance, by balls around both.
double balls_apart(const Placed& a, const Placed& b) {
  return (a.at * a.shape->aabb_center - b.at * b.shape->aabb_center).norm() - a.shape->aabb_radius -
         b.shape->aabb_radius;
}

bool may_touch(const Robot& robot, int a, int b) {
  const Link &first = robot.links[a], &second = robot.links[b];
  if (first.body == second.body || first.parent == b || second.parent == a) return true;
  return std::ranges::any_of(robot.may_touch, [&](const auto& pair) {
    return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
  });
}

bool breaks_limit(const Robot& robot, const Trajectory::State& state) {
  constexpr double kTolerance = 1e-9;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (state.q[j] < joint.low - kTolerance || state.q[j] > joint.high + kTolerance ||
        std::abs(state.dq[j]) > joint.velocity * (1 + kTolerance) ||
        std::abs(state.ddq[j]) > joint.acceleration * (1 + kTolerance)) {
      return true;
    }
  }
  return false;
}

void check(const Robot& robot, const Scene& scene, const Trajectory& trajectory, int samples) {
  validate(robot);
  validate(scene);
  if (trajectory.empty()) throw invalid_parameter("the trajectory is empty", "give it a knot");
  for (const Trajectory::Knot& knot : trajectory.knots()) {
    check_values(robot, as_span(knot.q));
    check_values(robot, as_span(knot.ddq), 1e300);
  }
  require_parameter(samples >= 1, "samples", samples, "it must be at least 1");
}

/// FCL has no mesh without triangles.
bool is_nothing(const Solid& s) {
  return s.shape == Solid::Shape::mesh && (s.triangles == nullptr || s.triangles->empty());
}

/// Checks a trajectory moment by moment, with KDL and FCL.
class TrajectoryChecker {
 public:
  TrajectoryChecker(const Robot& robot, const Scene& scene, const Trajectory& trajectory,
                    const StopCondition& stop)
      : robot_(robot), trajectory_(trajectory), chain_(make_chain(robot)), poller_(stop, 16) {
    for (const Obstacle& o : scene.obstacles)
      if (!is_nothing(o)) obstacles_.push_back(place(o));
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      for (const Solid& solid : robot.links[i].solids) {
        if (is_nothing(solid)) continue;
        parts_.push_back({place(solid), static_cast<int>(i), robot.links[i].body});
      }
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (!may_touch(robot, parts_[i].link, parts_[k].link)) pairs_.emplace_back(i, k);
      }
    }
    set_levers();
  }

  Recheck run(int samples) {
    found_ = {.nearest = kInfinity};
    Moment last;
    for (int s = 0; s < samples; ++s, ++found_.samples) {
      if (poller_.stop_after(1)) break;
      const double share = samples > 1 ? static_cast<double>(s) / (samples - 1) : 0;
      const Moment now = moment_at(share * trajectory_.duration());
      const Vec3 tip = tip_position(robot_, now.state.q);
      found_.tip_error = std::max(found_.tip_error, length(tip - now.tip));
      found_.nearest = std::min(found_.nearest, now.nearest);
      found_.contacts += now.nearest <= 0;
      found_.limits += breaks_limit(robot_, now.state);
      if (s > 0 && last.nearest > 0 && now.nearest > 0) {
        const bool free = is_free(last, now);
        if (poller_.stopped()) break;
        found_.unproven += !free;
      }
      last = now;
    }
    return found_;
  }

 private:
  static constexpr int kMostHalvings = 16;

  struct Moment {
    double time = 0;
    double nearest = 0;
    Trajectory::State state;
    Vec3 tip;
    Eigen::MatrixXd gaps;  // least between bodies, the first below the second; 0 stands still
  };

  /// How far any point moves at most while a joint turns by one radian, or slides by one metre.
  void set_levers() {
    std::vector<double> far(robot_.joints.size() + 1, 0);  // of what moves with a joint, and beyond
    for (const Part& part : parts_) {
      const Eigen::Vector3d middle = part.solid.at * part.solid.shape->aabb_center;
      far[part.body] = std::max(far[part.body], middle.norm() + part.solid.shape->aabb_radius);
    }
    levers_.assign(robot_.joints.size(), 1);
    double longest = 0;
    for (std::size_t j = robot_.joints.size(); j-- > 0;) {
      const Joint& joint = robot_.joints[j];
      longest = std::max(longest, far[j + 1]);
      if (joint.kind == Joint::Kind::revolute) {
        levers_[j] = longest;
      } else {
        longest += std::max(std::abs(joint.low), std::abs(joint.high));
      }
      longest += joint.frame.translation().norm();
    }
    most_.setZero(robot_.size());
    for (const auto& knot : trajectory_.knots()) most_ = most_.cwiseMax(knot.ddq.cwiseAbs());
  }

  Moment moment_at(double time) const {
    Moment now{time, kInfinity, trajectory_.at(time), {}, {}};
    now.gaps.setConstant(robot_.size() + 1, robot_.size() + 1, now.nearest);
    std::vector<fcl::Transform3d> bodies{fcl::Transform3d::Identity()};
    KDL::Frame at;
    for (int j = 0; j < robot_.size(); ++j) {
      at =
          at * chain_.getSegment(2 * j).pose(0) * chain_.getSegment(2 * j + 1).pose(now.state.q[j]);
      bodies.push_back(transform(at));
    }
    const KDL::Vector tip = at * vec(from_eigen(robot_.tip).position);
    now.tip = {tip.x(), tip.y(), tip.z()};

    std::vector<Placed> placed;
    placed.reserve(parts_.size());
    for (const Part& part : parts_) {
      placed.push_back({part.solid.shape, bodies[part.body] * part.solid.at});
    }
    const auto measure = [&](const Placed& a, int body, const Placed& b, int other) {
      double& least = now.gaps(std::min(body, other), std::max(body, other));
      if (balls_apart(a, b) >= least) return;
      least = std::min(least, distance(a, b));
    };
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].body == 0) continue;
      for (const Placed& o : obstacles_) measure(placed[i], parts_[i].body, o, 0);
    }
    for (const auto& [i, k] : pairs_) {
      measure(placed[i], parts_[i].body, placed[k], parts_[k].body);
    }
    now.nearest = now.gaps.minCoeff();
    return now;
  }

  /// Whether nothing that is apart at a moment touches where joints are up to `turn` from there: of
  /// two bodies only the joints between them count.
  bool stays_apart(const Moment& moment, const JointVector& turn) const {
    for (int a = 0; a < robot_.size(); ++a) {
      double nearing = 0;
      for (int b = a + 1; b <= robot_.size(); ++b) {
        nearing += levers_[b - 1] * turn[b - 1];
        if (moment.gaps(a, b) <= nearing) return false;
      }
    }
    return true;
  }

  /// Whether it can be shown that nothing touches between two samples, knot by knot.
  bool is_free(Moment from, const Moment& to) {
    for (const Trajectory::Knot& knot : trajectory_.knots()) {
      if (knot.time <= from.time || knot.time >= to.time) continue;
      Moment next = moment_at(knot.time);
      if (!is_free(from, next, kMostHalvings)) return false;
      from = std::move(next);
    }
    return is_free(from, to, kMostHalvings);
  }

  /// Whether it can be shown that nothing touches between two moments, with no knot between them,
  /// by looking between them as often as it takes.
  bool is_free(const Moment& a, const Moment& b, int halvings) {
    if (!(a.nearest > 0 && b.nearest > 0)) return false;
    // The joints stay within h^2 / 8 max |ddq| of the straight motion.
    const double h = b.time - a.time;
    const JointVector turn = 0.5 * (b.state.q - a.state.q).cwiseAbs() + h * h / 8 * most_;
    if (stays_apart(a, turn) && stays_apart(b, turn)) return true;
    if (halvings == 0 || poller_.stop_after(1)) return false;
    const Moment middle = moment_at(a.time + 0.5 * h);
    return is_free(a, middle, halvings - 1) && is_free(middle, b, halvings - 1);
  }

  const Robot& robot_;
  const Trajectory& trajectory_;
  KDL::Chain chain_;
  std::vector<Placed> obstacles_;
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // of parts that must not touch
  std::vector<double> levers_;                              // by joint
  JointVector most_;                                        // |ddq| by joint
  Poller poller_;
  Recheck found_;
};

}  // namespace

Recheck recheck(const Robot& robot, const Scene& scene, const Trajectory& trajectory, int samples,
                const StopCondition& stop) {
  check(robot, scene, trajectory, samples);
  return TrajectoryChecker(robot, scene, trajectory, stop).run(samples);
}

}  // namespace lasius::arm
