// How far the points of a robot's bodies may be from where a motion of the joints seems to
// bring them: bounds to the second order, for joints that turn and joints that slide.
//
// With s from -h to h around the middle q of a motion, joint k moves at the rate dq_k in the
// middle, which changes at c_k at most, a_k = |dq_k| + h c_k. Seen from frame j, a point of body i
// moves by the joints between; its velocity at the middle is v(p) = W x p + V, and |p(s) - p - s
// v(p)| <= s^2 / 2 (far + spread D), where D is its distance from the origin of body i.
// docs/theory.md has the proof.
#pragma once

#include <span>

#include "core/arm/robot/kinematics.h"

namespace lasius::arm {

/// How a body moves seen from another one, per unit of s.
struct RelativeMotion {
  Vec3 turn, shift;    // W and V, in the world
  double far = 0;      // metres
  double spread = 0;   // of each metre of D
  double turning = 0;  // at least |W|
};

class MotionBound {
 public:
  explicit MotionBound(const Kinematics& arm) : arm_(arm) {}

  /// `change` is dq, `bend` c, `half` h; `poses` are those of the middle.
  void set(std::span<const double> change, std::span<const double> bend, double half,
           const Kinematics::Poses& poses);
  /// The same where each joint goes straight.
  void set(std::span<const double> change, double half, const Kinematics::Poses& poses) {
    set(change, JointArray{}, half, poses);
  }
  /// Of body `body` seen from body `from`, below it; 0 is the base, i moves with joint i - 1.
  RelativeMotion of(int body, int from) const;

 private:
  const Kinematics& arm_;
  int joints_ = 0;
  double half_ = 0;
  JointArray rate_{}, bend_{};                        // a_k, c_k
  std::array<Vec3, Robot::kMaxJoints> turn_, shift_;  // of each joint
  std::array<Vec3, Robot::kMaxJoints> origin_;
  std::array<double, Robot::kMaxJoints> link_{};  // from the origin before, at the longest
};

}  // namespace lasius::arm
