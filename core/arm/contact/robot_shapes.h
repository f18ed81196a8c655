// What of a robot is tested against what, prepared once for any number of scenes.
#pragma once

#include <span>
#include <vector>

#include "core/arm/contact/inner_balls.h"
#include "core/arm/contact/shape.h"
#include "core/arm/robot/kinematics.h"

namespace lasius::arm {

/// Two shapes that must not touch, of bodies by number: 0 is the base, i moves with joint i - 1.
struct ShapePair {
  const Shape* a;
  const Shape* b;
  int body, from;  // of a and of b, which is below
};

/// A robot's links, prepared once for any number of scenes.
class RobotShapes {
 public:
  /// Precondition: a robot that `validate` accepts.
  explicit RobotShapes(const Robot& robot);

  const Kinematics& kinematics() const noexcept { return arm_; }
  /// All that moves with a body; null: nothing.
  const Shape* body(int i) const noexcept { return bodies_[i]; }
  std::span<const ShapePair> pairs() const noexcept { return pairs_; }
  int link_of(int solid) const noexcept { return links_[solid]; }
  /// Balls inside of what moves with a body, the largest first.
  const std::vector<InnerBall>& inner(int body) const noexcept { return inner_[body]; }

 private:
  Kinematics arm_;
  ShapeStore store_;
  std::vector<int> links_;  // of each solid
  std::vector<const Shape*> bodies_;
  std::vector<std::vector<InnerBall>> inner_;  // of each body
  std::vector<ShapePair> pairs_;
};

}  // namespace lasius::arm
