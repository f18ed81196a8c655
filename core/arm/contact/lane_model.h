// A robot and what stands around it, as kernels look at many postures at a time.
#pragma once

#include <vector>

#include "core/arm/contact/inner_balls.h"
#include "core/arm/contact/shape.h"
#include "core/arm/robot/kinematics.h"
#include "kernels/contact/lane_contact.h"

namespace lasius::arm {

/// What moves with each joint, in their order, and the part of it that each outer ball is around.
struct LaneModel {
  kernels::LaneRobot robot;
  std::vector<std::vector<const Shape*>> nodes;
  double size = 0;  // metres: no coordinate of a point of the robot is larger

  /// `bodies` by number from the base on, null where there is nothing; balls of each, the largest
  /// first. Precondition: a robot that `validate` accepts.
  LaneModel(const Robot& robot, const std::vector<const Shape*>& bodies,
            const std::vector<std::vector<InnerBall>>& inner);
  kernels::LaneObstacle obstacle(const Shape& shape) const;
};

}  // namespace lasius::arm
