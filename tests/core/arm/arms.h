// Arms and scenes for tests.
#pragma once

#include <string>
#include <vector>

#include "lasius/arm_generate.h"
#include "lasius/arm_plan.h"

namespace lasius::arm {

inline Robot shipped(const std::string& name) {
  return read_robot(LASIUS_MAPS_DIR "/arms/" + name + ".json");
}

/// Two links of 0.5 and 0.4 in the plane z = 0, wide limits, thin.
inline Robot two_links() {
  Robot robot;
  for (const double length : {0.5, 0.4}) {
    Joint joint;
    joint.origin = robot.joints.empty() ? Vec3{} : Vec3{0.5, 0, 0};
    joint.low = -3;
    joint.high = 3;
    joint.velocity = 2;
    joint.acceleration = 5;
    joint.capsules = {{{}, {length, 0, 0}, 0.01}};
    robot.joints.push_back(joint);
  }
  robot.tip = {0.4, 0, 0};
  return robot;
}

/// A question with a lattice of `side` points, most of them between start and goal.
inline Params lattice_of(const Robot& robot, const Request& request, int side) {
  const Vec3 from = tip_position(robot, request.start);
  const auto span = [](double a, double b) { return a < b ? b - a : a - b; };
  Params parameters;
  parameters.side = side;
  parameters.pitch = std::max({span(from.x, request.goal.x), span(from.y, request.goal.y),
                               span(from.z, request.goal.z)}) /
                     (0.6 * side);
  return parameters;
}

}  // namespace lasius::arm
