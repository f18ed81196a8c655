// Where a robot's bodies are, and joint values that bring its tip to a point.
#pragma once

#include <array>
#include <span>

#include "core/arm/robot/vec3.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {

/// Values of up to kMaxJoints joints.
using JointArray = std::array<double, Robot::kMaxJoints>;

/// A joint's name in messages: "joint 2 (elbow)".
std::string joint_name(const Robot& robot, int joint);

/// @throws Error(invalid_parameter) unless `q` holds a number for each joint, none beyond `most`.
void check_values(const Robot& robot, std::span<const double> q, double most = 1e6);

/// As `validate`, but for the corners of meshes, which may be many and only a sensor knows.
void validate_but_corners(const Robot& robot);

/// No point of what moves with joint `body` - 1 is further than this from its origin.
double extent(const Robot& robot, int body);

/// By joint j below `body` (that of joint i is i + 1): no point that is within `far` of the body's
/// origin is further from the axis of j, whatever the joints do; 1 where j is prismatic, for a
/// point moves as far as it does.
JointArray levers_of(const Robot& robot, int body, double far);

/// Where the tip's frame is to be, and how near is near enough: metres and radians.
struct TipTarget {
  Placement at;
  double position_tolerance = 0;
  double angle_tolerance = 0;  // pi or more: any orientation
};

/// The turn from one frame to another as a vector: its axis, as long as its angle.
Vec3 turn_between(const Rotation& from, const Rotation& to) noexcept;

class Kinematics {
 public:
  /// Precondition: a robot that `validate` accepts.
  explicit Kinematics(const Robot& robot);

  int size() const noexcept { return size_; }
  bool slides(int joint) const noexcept { return links_[joint].slides; }

  /// Poses of the bodies that move with each joint.
  using Poses = std::array<Placement, Robot::kMaxJoints>;
  void place(std::span<const double> q, Poses& poses) const noexcept;
  Vec3 tip(const Poses& poses) const noexcept { return poses[size() - 1] * tip_.position; }
  /// The tip's frame.
  Placement tip_frame(const Poses& poses) const noexcept { return poses[size() - 1] * tip_; }
  /// Least and largest value of a joint.
  double low(int joint) const noexcept { return links_[joint].low; }
  double high(int joint) const noexcept { return links_[joint].high; }
  /// A joint's axis in the world: its own turn leaves it where it is.
  Vec3 axis(int joint, const Poses& poses) const noexcept {
    return poses[joint].rotation * links_[joint].axis;
  }

  /// The tip is not further from the first joint's origin than this, whatever the joints do.
  double reach() const noexcept { return reach_; }
  /// Nor nearer than this: what one link is longer than all others together.
  double least_reach() const noexcept { return least_reach_; }
  Vec3 shoulder() const noexcept { return links_[0].frame.position; }

  /// Brings the tip to `target`, starting from `q`, which is overwritten; false where it does not
  /// get there, `q` is then the last attempt. Among the solutions near the start the one nearest to
  /// `rest` is sought. Joint limits hold. Kinematics only; the same on every machine.
  ///
  /// Damped least squares with its damping proportional to the squared error (Levenberg's rule, as
  /// in Sugihara 2011), and a pull towards `rest` in the null space; a joint at its limit takes no
  /// further part in a step that would push it out.
  bool reach_for(Vec3 target, std::span<const double> rest, std::span<double> q) const noexcept;

  /// Brings the tip's frame to within the tolerances of `target`, starting from `q`, which is
  /// overwritten; false where it does not get there. No pull towards rest values.
  bool reach_pose(const TipTarget& target, std::span<double> q) const noexcept;
  /// True when the tip's frame is within the tolerances.
  bool is_at(const TipTarget& target, std::span<const double> q) const noexcept;

  /// Folds the joints to and fro by `amount`, radians or metres, every other one the other way, as
  /// far as their limits let them.
  void bend(std::span<double> q, double amount) const noexcept;

  /// The tip is within this of a target that was reached.
  static constexpr double kTolerance = 1e-7;

 private:
  /// One step of `reach_for`; the furthest that a joint moved. `poses` are those of `q` before it.
  /// A joint that the step would push past its limit is held there, and the step taken anew.
  double step_towards(Vec3 target, const Poses& poses, std::span<const double> rest,
                      std::span<double> q) const noexcept;

  /// A joint, as the arithmetic wants it.
  struct Link {
    Placement frame;  // at value 0, in that of the joint before
    Vec3 axis;
    double low, high;
    bool slides;
    bool turned;  // its frame is
  };

  int size_;
  std::array<Link, Robot::kMaxJoints> links_{};
  Placement tip_;
  double reach_ = 0;
  double least_reach_ = 0;
};

}  // namespace lasius::arm
