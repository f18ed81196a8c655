#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/arm/ends.h"
#include "core/arm/part.h"
#include "core/arm/robot/kinematics.h"
#include "core/arm/robot/solid.h"
#include "core/base/invalid_parameter.h"
#include "core/base/special_values.h"
#include "lasius/arm_sensor.h"

namespace lasius::arm {

class SceneSensor::Impl {
 public:
  Impl(const Robot& robot, const Scene& scene, double clearance)
      : robot_(robot), scene_(scene), kinematics_(robot_), clearance_(clearance) {
    obstacles_.reserve(scene_.obstacles.size());  // what is placed points to it
    for (const Obstacle& o : scene_.obstacles) {
      obstacles_.emplace_back(o);
      placed_.push_back(obstacles_.back().place({}));
    }
    std::vector<int> first;  // part of each link, and the end
    for (const Link& link : robot_.links) {
      first.push_back(static_cast<int>(parts_.size()));
      for (const Solid& solid : link.solids) {
        parts_.emplace_back(solid);
        link_.push_back(static_cast<int>(first.size()) - 1);
        levers_.push_back(levers_of(robot_, link.body, extent(solid)));
        capsules_ = capsules_ && solid.shape == Solid::Shape::capsule;
      }
    }
    first.push_back(static_cast<int>(parts_.size()));
    for (const auto& [a, b, check] : link_pairs(robot_)) {
      if (check != LinkPair::Check::yes) continue;
      for (int i = first[a]; i < first[a + 1]; ++i) {
        for (int k = first[b]; k < first[b + 1]; ++k) pairs_.emplace_back(i, k);
      }
    }
  }

  /// Follows a motion; a position is one of no length. Where it is not free and `told` is given,
  /// says there what is in the way.
  bool is_free(std::span<const double> from, std::span<const double> to,
               std::string* told = nullptr) const {
    check_values(robot_, from);
    check_values(robot_, to);
    Frame frame;
    const bool moves = set_speeds(from, to, frame);
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

  double distance(std::span<const double> q) const {
    check_values(robot_, q);
    Frame frame;
    place(q, frame);
    double nearest = kInfinity;
    const auto offer = [&](const Part::Placed& a, const Part::Placed& b) {
      if (gap_between(a.ball, b.ball) < nearest)
        nearest = std::min(nearest, distance_between(a, b, nearest));
    };
    for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
      if (body(i) == 0) continue;
      for (const Part::Placed& obstacle : placed_) offer(frame.parts[i], obstacle);
    }
    for (const auto& [a, b] : pairs_) offer(frame.parts[a], frame.parts[b]);
    return std::max(nearest, 0.0);
  }

 private:
  struct Frame {
    std::vector<Part::Placed> parts;
    std::vector<double> speed;    // of each part, per unit of t
    std::vector<double> nearing;  // of each of `pairs_`: at most so fast
  };

  int body(int part) const noexcept { return robot_.links[link_[part]].body; }
  std::string name(int part) const { return link_name(robot_, link_[part]); }

  /// How fast joints from `first` on move a part at most, in the frame before them.
  double speed(std::span<const double> from, std::span<const double> to, int first,
               int part) const noexcept {
    double sum = 0;
    for (int j = first; j < body(part); ++j) sum += std::abs(to[j] - from[j]) * levers_[part][j];
    return sum;
  }

  /// False when nothing moves.
  bool set_speeds(std::span<const double> from, std::span<const double> to, Frame& frame) const {
    double all = 0;
    for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
      frame.speed.push_back(speed(from, to, 0, i));
      all += frame.speed.back();
    }
    for (const auto& [a, b] : pairs_) {
      const auto [first, last] = body(a) < body(b) ? std::pair(a, b) : std::pair(b, a);
      // Only the joints between two links bring them nearer. Robots of capsules are followed more
      // slowly, as they ever were: their saved results replay.
      frame.nearing.push_back(capsules_ ? frame.speed[a] + frame.speed[b]
                                        : speed(from, to, body(first), last));
    }
    return all > 0;
  }

  void place(std::span<const double> q, Frame& frame) const {
    Kinematics::Poses poses;
    kinematics_.place(q, poses);
    frame.parts.clear();
    for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
      frame.parts.push_back(parts_[i].place(body(i) == 0 ? Placement{} : poses[body(i) - 1]));
    }
  }

  /// Shortens `step` so that two parts that near each other at `speed` do not touch in it; false
  /// where they do now. Those that pass are twice the clearance apart: steps have a least length,
  /// and the motion ends.
  bool shorten(const Part::Placed& a, const Part::Placed& b, double speed, double& step,
               double* nearest) const {
    // Nothing nearer than this matters: neither contact nor a shorter step.
    const double enough = std::max(2 * clearance_, clearance_ + step * speed);
    if (gap_between(a.ball, b.ball) >= enough) return true;
    const double gap = distance_between(a, b, enough);
    if (gap >= enough) return true;
    if (gap < 2 * clearance_) {
      *nearest = gap;
      return false;
    }
    step = std::min(step, (gap - clearance_) / speed);
    return true;
  }

  /// Shortens `step` to what all distances allow; false on contact.
  bool advance(const Frame& frame, double& step, std::string* told) const {
    double gap = 0;
    for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
      if (body(i) == 0) continue;
      for (std::size_t o = 0; o < placed_.size(); ++o) {
        if (shorten(frame.parts[i], placed_[o], frame.speed[i], step, &gap)) continue;
        if (told != nullptr) *told = name(i) + " and " + obstacle_name(o) + apart(gap);
        return false;
      }
    }
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const auto& [a, b] = pairs_[p];
      if (shorten(frame.parts[a], frame.parts[b], frame.nearing[p], step, &gap)) continue;
      if (told != nullptr) *told = name(a) + " and " + name(b) + apart(gap);
      return false;
    }
    return true;
  }

  /// What is said of two that count as touching and do not.
  std::string apart(double gap) const {
    if (!(gap > 0)) return {};
    const auto [is, least] = metres(gap, 2 * clearance_);
    return ", " + is + " m apart (less than twice the clearance, " + least +
           " m, counts as touching)";
  }

  std::string obstacle_name(std::size_t index) const {
    const std::string& name = scene_.obstacles[index].name;
    return "obstacle " + std::to_string(index + 1) + (name.empty() ? "" : " (" + name + ")");
  }

  const Robot robot_;
  const Scene scene_;
  const Kinematics kinematics_;
  double clearance_;
  std::vector<Part> obstacles_;
  std::vector<Part::Placed> placed_;        // the obstacles
  std::vector<Part> parts_;                 // of the robot
  std::vector<int> link_;                   // of each part
  std::vector<JointArray> levers_;          // of each part: the joints' reach to any point of it
  std::vector<std::pair<int, int>> pairs_;  // of parts that must not touch
  bool capsules_ = true;                    // no other parts

  friend class SceneSensor;
};

Sensor::~Sensor() = default;
std::string Sensor::contact(const JointRef&) const { return {}; }

SceneSensor::SceneSensor(const Robot& robot, const Scene& scene, double clearance) {
  validate(robot);
  validate(scene);
  require_parameter(clearance >= kLeastClearance && clearance <= 1, "clearance", clearance,
                    "it must be 0.000001 .. 1 metres");
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
double SceneSensor::distance(const JointRef& q) const { return impl_->distance(as_span(q)); }
std::string SceneSensor::contact(const JointRef& q) const {
  std::string told;
  impl_->is_free(as_span(q), as_span(q), &told);
  return told;
}

}  // namespace lasius::arm
