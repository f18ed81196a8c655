#include "lasius/arm/sensor.h"

#include <string>
#include <utility>
#include <vector>

#include "core/arm/contact/contact.h"
#include "core/arm/ends.h"
#include "core/base/invalid_parameter.h"
#include "core/base/special_values.h"
#include "lasius/arm/trajectory.h"

namespace lasius::arm {

class SceneSensor::Impl {
 public:
  Impl(std::shared_ptr<const Robot> robot, std::shared_ptr<const RobotShapes> shapes,
       const Scene& scene)
      : robot_(std::move(robot)), scene_(scene), contact_(std::move(shapes), scene_) {}

  Impl(const Impl& other, const Scene& scene) : Impl(other.robot_, other.contact_.robot(), scene) {}

  double clearance() const noexcept { return contact_.robot()->clearance(); }

  bool is_free(const JointRef& q) const { return contact_.posture_free(checked(q)); }
  std::optional<bool> motion(const JointRef& from, const JointRef& to,
                             const StopCondition& stop) const {
    return known(contact_.motion(checked(from), checked(to), stop));
  }
  std::optional<bool> curve(const Trajectory& trajectory, double from, double to,
                            const StopCondition& stop) const {
    constexpr double kMostBend = 1e12;  // an acceleration may be larger than a value
    const double whole = to - from;
    if (!(whole > 0)) return is_free(trajectory.at(from).q);
    const auto& knots = trajectory.knots();
    std::vector<CurvePiece> pieces;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const auto &a = knots[i], &b = knots[i + 1];
      const double h = b.time - a.time;
      if (!(h > 0) || b.time <= from || a.time >= to) continue;
      const auto q = checked(a.q), next = checked(b.q), bend = as_span(a.ddq),
                 last = as_span(b.ddq);
      check_values(*robot_, bend, kMostBend);
      check_values(*robot_, last, kMostBend);
      CurvePiece& piece = pieces.emplace_back();
      piece.begin = (a.time - from) / whole;
      for (std::size_t j = 0; j < q.size(); ++j) {
        piece.q[j] = q[j];
        piece.first[j] = whole * ((next[j] - q[j]) / h - h * (2 * bend[j] + last[j]) / 6);
        piece.second[j] = whole * whole * bend[j];
        piece.third[j] = whole * whole * whole * ((last[j] - bend[j]) / h);
      }
    }
    if (pieces.empty()) return is_free(trajectory.at(from).q);
    const auto joints = static_cast<std::size_t>(robot_->size());
    return known(contact_.motion(JointCurve(joints, pieces), stop));
  }
  Nearest nearest(const JointRef& q) const {
    const NearPair pair = contact_.nearest(checked(q));
    if (pair.link < 0) return {kInfinity, {}, {}};
    return {pair.distance, link_name(*robot_, pair.link), other_name(pair)};
  }
  /// What is said of the two that are nearest, which count as touching.
  std::string told(const JointRef& q) const {
    const NearPair pair = contact_.nearest(checked(q));
    std::string text = link_name(*robot_, pair.link) + " and " + other_name(pair);
    if (!(pair.distance > 0)) return text;
    const auto [is, least] = metres(pair.distance, 2 * clearance());
    return text + ", " + is + " m apart (less than twice the clearance, " + least +
           " m, counts as touching)";
  }

 private:
  static std::optional<bool> known(Contact::Answer answer) {
    if (answer == Contact::Answer::stopped) return std::nullopt;
    return answer == Contact::Answer::free;
  }
  std::span<const double> checked(const JointRef& q) const {
    check_values(*robot_, as_span(q));
    return as_span(q);
  }
  std::string other_name(const NearPair& pair) const {
    if (pair.obstacle < 0) return link_name(*robot_, pair.other);
    const std::string& name = scene_.obstacles[pair.obstacle].name;
    return "obstacle " + std::to_string(pair.obstacle + 1) +
           (name.empty() ? "" : " (" + name + ")");
  }

  std::shared_ptr<const Robot> robot_;
  Scene scene_;
  Contact contact_;
};

Sensor::~Sensor() = default;
std::string Sensor::contact(const JointRef&) const { return {}; }
std::optional<bool> Sensor::try_motion(const JointRef& from, const JointRef& to,
                                       const StopCondition&) const {
  return motion_free(from, to);
}
std::optional<bool> Sensor::try_curve(const Trajectory&, double, double,
                                      const StopCondition&) const {
  return std::nullopt;
}

SceneSensor::SceneSensor(const Robot& robot, const Scene& scene, double clearance) {
  validate(robot);
  validate(scene);
  require_parameter(clearance >= kLeastClearance && clearance <= 1, "clearance", clearance,
                    "it must be 0.000001 .. 1 metres");
  auto kept = std::make_shared<const Robot>(robot);
  auto shapes = std::make_shared<const RobotShapes>(*kept, clearance);
  impl_ = std::make_unique<const Impl>(std::move(kept), std::move(shapes), scene);
}
SceneSensor::SceneSensor(const SceneSensor& other, const Scene& scene) {
  validate(scene);
  impl_ = std::make_unique<const Impl>(*other.impl_, scene);
}
SceneSensor::~SceneSensor() = default;

bool SceneSensor::position_free(const JointRef& q) const { return impl_->is_free(q); }
bool SceneSensor::motion_free(const JointRef& from, const JointRef& to) const {
  return impl_->motion(from, to, {}).value_or(false);
}
std::optional<bool> SceneSensor::try_motion(const JointRef& from, const JointRef& to,
                                            const StopCondition& stop) const {
  return impl_->motion(from, to, stop);
}
std::optional<bool> SceneSensor::try_curve(const Trajectory& trajectory, double from, double to,
                                           const StopCondition& stop) const {
  return impl_->curve(trajectory, from, to, stop);
}
double SceneSensor::clearance() const { return impl_->clearance(); }
double SceneSensor::distance(const JointRef& q) const { return impl_->nearest(q).distance; }
SceneSensor::Nearest SceneSensor::nearest(const JointRef& q) const { return impl_->nearest(q); }
std::string SceneSensor::contact(const JointRef& q) const {
  return impl_->is_free(q) ? std::string() : impl_->told(q);
}

}  // namespace lasius::arm
