#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/arm/kinematics.h"
#include "core/arm/mesh_tree.h"
#include "core/arm/proximity.h"
#include "core/base/number_text.h"
#include "lasius/arm_sensor.h"
#include "lasius/error.h"

namespace lasius::arm {
namespace {

/// A point that no point of the thing is further from than `radius`.
struct Ball {
  Vec3 centre;
  double radius = 0;
};

double gap_between(const Ball& a, const Ball& b) noexcept {
  return distance(a.centre, b.centre) - a.radius - b.radius;
}

/// Two bodies of the robot that must not touch; 0 is the base.
struct BodyPair {
  int first, second;
};

/// A capsule of a body, in the body's frame.
struct Shape {
  Segment axis;
  double radius;
  double half;  // of its axis

  explicit Shape(const Capsule& c)
      : axis{c.from, c.to}, radius(c.radius), half(0.5 * length(axis.to - axis.from)) {}
};

/// The same at its place.
struct PlacedCapsule {
  Segment axis;
  double radius;
  Ball ball;

  PlacedCapsule() = default;
  PlacedCapsule(const Placement& pose, const Shape& shape)
      : axis{pose * shape.axis.from, pose * shape.axis.to},
        radius(shape.radius),
        ball{0.5 * (axis.from + axis.to), shape.half + shape.radius} {}
};

struct PlacedObstacle {
  const Obstacle* obstacle;
  Placement pose;
  Vec3 size;
  Ball ball;
  std::optional<MeshTree> mesh;

  explicit PlacedObstacle(const Obstacle& o)
      : obstacle(&o), pose(from_eigen(o.pose)), size(o.size), ball{pose.position, 0} {
    switch (o.shape) {
      case Obstacle::Shape::box:
        ball.radius = 0.5 * length(size);
        break;
      case Obstacle::Shape::sphere:
        ball.radius = o.radius;
        break;
      case Obstacle::Shape::cylinder:
        ball.radius = std::sqrt(o.radius * o.radius + 0.25 * o.length * o.length);
        break;
      case Obstacle::Shape::mesh: {
        std::vector<Triangle> triangles;
        for (const auto& [a, b, c] : o.triangles) {
          triangles.push_back({a, b, c});
          for (const Vec3 corner : triangles.back()) {
            ball.radius = std::max(ball.radius, length(corner));
          }
        }
        mesh.emplace(std::move(triangles));
        break;
      }
    }
  }

  /// From a segment; for a mesh at most `limit` is told.
  double distance(const Segment& s, double limit) const noexcept {
    const Obstacle& o = *obstacle;
    if (o.shape == Obstacle::Shape::sphere) return distance_to_point(s, pose.position) - o.radius;
    const Segment local{rotate_back(pose.rotation, s.from - pose.position),
                        rotate_back(pose.rotation, s.to - pose.position)};
    switch (o.shape) {
      case Obstacle::Shape::box:
        return distance_to_box(local, 0.5 * size);
      case Obstacle::Shape::cylinder:
        return distance_to_cylinder(local, o.radius, 0.5 * o.length);
      case Obstacle::Shape::sphere:  // above
      case Obstacle::Shape::mesh:
        break;
    }
    return mesh->distance(local, limit);
  }
};

}  // namespace

class SceneSensor::Impl {
 public:
  Impl(const Robot& robot, const Scene& scene, double clearance)
      : robot_(robot), scene_(scene), kinematics_(robot_), clearance_(clearance) {
    for (const Obstacle& o : scene_.obstacles) obstacles_.emplace_back(o);
    const int bodies = robot_.size() + 1;
    for (int b = 0; b < bodies; ++b) {
      first_.push_back(static_cast<int>(shapes_.size()));
      for (const Capsule& c : capsules(b)) shapes_.emplace_back(c);
    }
    first_.push_back(static_cast<int>(shapes_.size()));
    for (int b = 2; b < bodies; ++b) {
      for (int a = 0; a + 1 < b; ++a) {
        const std::pair pair{a, b}, mirrored{b, a};
        const auto& free = robot_.may_touch;
        const bool may = std::find(free.begin(), free.end(), pair) != free.end() ||
                         std::find(free.begin(), free.end(), mirrored) != free.end();
        if (!may) pairs_.push_back({a, b});
      }
    }
    set_levers();
  }

  /// Follows a motion; a position is one of no length. Where it is not free and `told` is given,
  /// says there what is in the way.
  bool is_free(std::span<const double> from, std::span<const double> to,
               std::string* told = nullptr) const {
    check_values(robot_, from);
    check_values(robot_, to);
    Frame frame;
    const bool moves = set_speeds(from, to, frame.speed);
    JointArray q;
    for (double t = 0;;) {
      for (int j = 0; j < robot_.size(); ++j) q[j] = from[j] + t * (to[j] - from[j]);
      place(q, frame);
      double step = 1 - t;
      if (!advance(frame, step, told)) return false;
      if (t >= 1 || !moves) return true;
      t = step >= 1 - t ? 1 : t + step;
    }
  }

  double clearance() const noexcept { return clearance_; }

 private:
  static constexpr int kMostCapsules = 128;

  struct Frame {
    std::array<PlacedCapsule, kMostCapsules> capsules;
    std::array<double, Robot::kMaxJoints + 1> speed{};  // of each body, per unit of t
  };

  const std::vector<Capsule>& capsules(int body) const {
    return body == 0 ? robot_.base : robot_.joints[body - 1].capsules;
  }

  /// lever_[j][b]: no point of body b is further from the axis of joint j.
  void set_levers() {
    for (int b = 1; b <= robot_.size(); ++b) {
      const auto lever = levers_of(robot_, b, extent(capsules(b)));
      for (int j = 0; j < b; ++j) lever_[j][b] = lever[j];
    }
  }

  /// False when nothing moves.
  bool set_speeds(std::span<const double> from, std::span<const double> to,
                  std::array<double, Robot::kMaxJoints + 1>& speed) const noexcept {
    double all = 0;
    for (int b = 1; b <= robot_.size(); ++b) {
      for (int j = 0; j < b; ++j) speed[b] += std::abs(to[j] - from[j]) * lever_[j][b];
      all += speed[b];
    }
    return all > 0;
  }

  void place(std::span<const double> q, Frame& frame) const noexcept {
    Kinematics::Poses poses;
    kinematics_.place(q, poses);
    for (int b = 0; b <= robot_.size(); ++b) {
      const Placement pose = b == 0 ? Placement{} : poses[b - 1];
      for (int i = first_[b]; i < first_[b + 1]; ++i) {
        frame.capsules[i] = PlacedCapsule(pose, shapes_[i]);
      }
    }
  }

  /// Shortens `step` so that two things that near each other at `speed` do not touch in it; false
  /// where they do now. Their distance is at least `apart`, and `measure(enough)` wherever it is
  /// below `enough`. Those that pass are twice the clearance apart: steps have a least length, and
  /// the motion ends.
  template <class Measure>
  bool shorten(double apart, double speed, const Measure& measure, double& step) const {
    // Nothing nearer than this matters: neither contact nor a shorter step.
    const double enough = std::max(2 * clearance_, clearance_ + step * speed);
    if (apart >= enough) return true;
    const double gap = measure(enough);
    if (gap >= enough) return true;
    if (gap < 2 * clearance_) return false;
    step = std::min(step, (gap - clearance_) / speed);
    return true;
  }

  /// Shortens `step` to what all distances allow; false on contact.
  bool advance(const Frame& frame, double& step, std::string* told) const {
    for (int b = 1; b <= robot_.size(); ++b) {
      for (const PlacedObstacle& o : obstacles_) {
        for (int i = first_[b]; i < first_[b + 1]; ++i) {
          const PlacedCapsule& c = frame.capsules[i];
          const auto measure = [&](double enough) {
            return o.distance(c.axis, enough + c.radius) - c.radius;
          };
          if (shorten(gap_between(c.ball, o.ball), frame.speed[b], measure, step)) continue;
          if (told != nullptr) *told = name(b) + " and " + name(o);
          return false;
        }
      }
    }
    for (const BodyPair& pair : pairs_) {
      const double speed = frame.speed[pair.first] + frame.speed[pair.second];
      for (int i = first_[pair.first]; i < first_[pair.first + 1]; ++i) {
        for (int k = first_[pair.second]; k < first_[pair.second + 1]; ++k) {
          const PlacedCapsule &a = frame.capsules[i], &c = frame.capsules[k];
          const auto measure = [&](double) {
            return distance_to_segment(a.axis, c.axis) - a.radius - c.radius;
          };
          if (shorten(gap_between(a.ball, c.ball), speed, measure, step)) continue;
          if (told != nullptr) *told = name(pair.first) + " and " + name(pair.second);
          return false;
        }
      }
    }
    return true;
  }

  std::string name(int body) const {
    if (body == 0) return "the base";
    const std::string& joint = robot_.joints[body - 1].name;
    return "link " + std::to_string(body) + (joint.empty() ? "" : " (after " + joint + ")");
  }
  std::string name(const PlacedObstacle& o) const {
    const auto index = o.obstacle - scene_.obstacles.data() + 1;
    return "obstacle " + std::to_string(index) +
           (o.obstacle->name.empty() ? "" : " (" + o.obstacle->name + ")");
  }

  const Robot robot_;
  const Scene scene_;
  const Kinematics kinematics_;
  double clearance_;
  std::vector<PlacedObstacle> obstacles_;
  std::vector<Shape> shapes_;  // body by body
  std::vector<int> first_;     // of each body in `shapes_`, and the end
  std::vector<BodyPair> pairs_;
  std::array<std::array<double, Robot::kMaxJoints + 1>, Robot::kMaxJoints> lever_{};

  friend class SceneSensor;
};

Sensor::~Sensor() = default;
std::string Sensor::contact(const JointRef&) const { return {}; }

SceneSensor::SceneSensor(const Robot& robot, const Scene& scene, double clearance) {
  validate(robot);
  validate(scene);
  if (!(clearance >= kLeastClearance && clearance <= 1)) {
    throw Error(ErrorCode::invalid_parameter, "clearance is " + number_text(clearance),
                "it must be 0.000001 .. 1 metres");
  }
  impl_ = std::make_unique<const Impl>(robot, scene, clearance);
}
SceneSensor::~SceneSensor() = default;

bool SceneSensor::position_free(const JointRef& q) const {
  return impl_->is_free(as_span(q), as_span(q));
}
bool SceneSensor::motion_free(const JointRef& from, const JointRef& to) const {
  return impl_->is_free(as_span(from), as_span(to));
}
double SceneSensor::clearance() const { return impl_->clearance(); }
std::string SceneSensor::contact(const JointRef& q) const {
  std::string told;
  impl_->is_free(as_span(q), as_span(q), &told);
  return told;
}

}  // namespace lasius::arm
