#include "core/arm/robot/kinematics.h"

#include <string>

#include "core/arm/robot/solid.h"
#include "core/base/invalid_parameter.h"

namespace lasius::arm {
namespace {

/// A 3 x 3 symmetric matrix, and its inverse applied to a vector.
struct Symmetric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(Vec3 column) noexcept {
    xx += column.x * column.x;
    xy += column.x * column.y;
    xz += column.x * column.z;
    yy += column.y * column.y;
    yz += column.y * column.z;
    zz += column.z * column.z;
  }
  /// By cofactors. The damping on the diagonal keeps the determinant above 0.
  Vec3 solve(Vec3 b) const noexcept {
    const Vec3 r0{yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy};
    const Vec3 r1{r0.y, xx * zz - xz * xz, xy * xz - xx * yz};
    const Vec3 r2{r0.z, r1.z, xx * yy - xy * xy};
    const double determinant = xx * r0.x + xy * r0.y + xz * r0.z;
    return (1 / determinant) * Vec3{dot(r0, b), dot(r1, b), dot(r2, b)};
  }
};

/// A step of the solver.
struct Step {
  int joints;
  Vec3 error;                                       // what is left for the joints that are not held
  std::array<Vec3, Robot::kMaxJoints> column = {};  // how the tip moves with each joint
  JointArray pull = {};                             // towards the posture at rest
  std::array<bool, Robot::kMaxJoints> held = {};

  /// The joint goes no further than by this, to its limit.
  void hold(int joint, double change) noexcept {
    held[joint] = true;
    error = error - change * column[joint];
  }

  /// Changes of the joints that are not held.
  JointArray solve() const noexcept {
    constexpr double kDamping = 0.02;     // of the squared error
    constexpr double kLongestStep = 0.5;  // radians or metres
    const double damping = kDamping * dot(error, error) + 1e-12;
    // dq = J^T A^-1 e + (z - J^T A^-1 J z) with z the pull: one solve for both.
    Symmetric normal;
    Vec3 wanted = error;
    for (int j = 0; j < joints; ++j) {
      if (held[j]) continue;
      normal.add(column[j]);
      wanted = wanted - pull[j] * column[j];
    }
    normal.xx += damping;
    normal.yy += damping;
    normal.zz += damping;
    const Vec3 force = normal.solve(wanted);
    JointArray change{};
    double longest = 0;
    for (int j = 0; j < joints; ++j) {
      if (!held[j]) change[j] = pull[j] + dot(column[j], force);
      longest = std::max(longest, std::abs(change[j]));
    }
    const double shrink = longest > kLongestStep ? kLongestStep / longest : 1;
    for (double& value : change) value *= shrink;
    return change;
  }
};

}  // namespace

std::string joint_name(const Robot& robot, int joint) {
  const std::string& name = robot.joints[joint].name;
  return "joint " + std::to_string(joint + 1) + (name.empty() ? "" : " (" + name + ")");
}

void check_values(const Robot& robot, std::span<const double> q, double most) {
  if (q.size() != robot.joints.size())
    refuse("a position has " + std::to_string(q.size()) + " values",
           "it must have one for each of the " + std::to_string(robot.joints.size()) + " joints");
  if (!std::ranges::all_of(q, [most](double value) { return std::abs(value) <= most; }))
    refuse("a position has a joint value that is no number or too large",
           "give numbers from -1000000 to 1000000");
}

double extent(const Robot& robot, int body) {
  double far = 0;
  for (const Link& link : robot.links) {
    if (link.body != body) continue;
    for (const Solid& solid : link.solids) far = std::max(far, extent(solid));
  }
  return far;
}

JointArray levers_of(const Robot& robot, int body, double far) {
  JointArray lever{};
  for (int j = body - 1; j >= 0; --j) {
    const Joint& joint = robot.joints[j];
    lever[j] = joint.kind == Joint::Kind::prismatic ? 1 : far;
    if (joint.kind == Joint::Kind::prismatic)
      far += std::max(std::abs(joint.low), std::abs(joint.high));
    far += length(from_eigen(joint.frame).position);
  }
  return lever;
}

Kinematics::Kinematics(const Robot& robot) : size_(robot.size()), tip_(from_eigen(robot.tip)) {
  double longest = 0;  // of the links; that of what slides is not fixed
  const auto add_link = [&](double length) {
    reach_ += length;
    longest = std::max(longest, length);
  };
  for (int j = 0; j < size_; ++j) {
    const Joint& joint = robot.joints[j];
    const Placement frame = from_eigen(joint.frame);
    links_[j] = {.frame = frame,
                 .axis = joint.axis,
                 .low = joint.low,
                 .high = joint.high,
                 .slides = joint.kind == Joint::Kind::prismatic,
                 .turned = frame.rotation != kNoRotation};
    if (j > 0) add_link(length(frame.position));
    if (slides(j)) reach_ += std::max(std::abs(joint.low), std::abs(joint.high));
  }
  add_link(length(tip_.position));
  least_reach_ = std::max(0.0, 2 * longest - reach_);
}

void Kinematics::place(std::span<const double> q, Poses& poses) const noexcept {
  Placement at;
  for (int j = 0; j < size(); ++j) {
    const Link& link = links_[j];
    const Rotation frame = link.turned ? at.rotation * link.frame.rotation : at.rotation;
    const Vec3 origin = at * link.frame.position;
    if (link.slides)
      at = {frame, origin + q[j] * (frame * link.axis)};
    else
      at = {frame * rotation_about(link.axis, q[j]), origin};
    poses[j] = at;
  }
}

void Kinematics::bend(std::span<double> q, double amount) const noexcept {
  for (std::size_t j = 0; j < q.size(); ++j)
    q[j] = std::clamp(q[j] + (j == 0 ? -amount : amount), links_[j].low, links_[j].high);
}

double Kinematics::step_towards(Vec3 target, const Poses& poses, std::span<const double> rest,
                                std::span<double> q) const noexcept {
  constexpr double kPull = 0.5;  // share of the way to `rest` a step
  const Vec3 at = tip(poses);
  Step step{.joints = size(), .error = target - at};
  for (int j = 0; j < size(); ++j) {
    const Vec3 along = axis(j, poses);
    step.column[j] = slides(j) ? along : cross(along, at - poses[j].position);
    step.pull[j] = kPull * (rest[j] - q[j]);
  }
  double moved = 0;
  JointArray change{};
  for (bool pushed = true; pushed;) {
    change = step.solve();
    pushed = false;
    for (int j = 0; j < size(); ++j) {
      const Link& link = links_[j];
      const double next = q[j] + change[j];
      if (step.held[j] || (next >= link.low && next <= link.high)) continue;
      const double limit = std::clamp(next, link.low, link.high);
      moved = std::max(moved, std::abs(limit - q[j]));
      step.hold(j, limit - q[j]);
      q[j] = limit;
      pushed = true;
    }
  }
  for (int j = 0; j < size(); ++j) {
    moved = std::max(moved, std::abs(change[j]));
    q[j] += change[j];
  }
  return moved;
}

bool Kinematics::reach_for(Vec3 target, std::span<const double> rest,
                           std::span<double> q) const noexcept {
  constexpr int kMostSteps = 60;
  constexpr double kStill = 1e-6;  // radians or metres: the pull has come to rest
  if (distance(target, shoulder()) > reach_ + kTolerance) return false;

  Poses poses;
  for (int count = 0; count < kMostSteps; ++count) {
    place(q, poses);
    const double moved = step_towards(target, poses, rest, q);
    if (moved < kStill || count + 1 == kMostSteps) {
      place(q, poses);
      if (distance(target, tip(poses)) <= kTolerance) return true;
    }
  }
  return false;
}

}  // namespace lasius::arm
