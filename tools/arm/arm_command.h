// What the command line asks of an arm.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/options/options.h"

namespace lasius::tool {

/// What an arm is to reach.
struct ArmGoal {
  enum class Kind { position, pose, joints };
  Kind kind = Kind::position;
  std::vector<double> values;  ///< x, y, z; and roll, pitch, yaw; or a value for each joint
  std::string state;           ///< name of the joint values; empty: `values` says them
};
inline constexpr std::array<std::string_view, 3> kGoalKinds{"position", "pose", "joints"};

struct ArmCommand : SearchOptions {
  static constexpr double kLeastClearance = 1e-6, kMostClearance = 1;
  static constexpr double kLeastRate = 1e-3, kMostRate = 1e5;
  static constexpr double kLeastDuration = 1e-3, kMostDuration = 1e6;
  static constexpr double kLeastTolerance = 1e-7, kMostTolerance = 10;
  static constexpr int kMostRecheck = 1000000;
  static constexpr double kLeastOff = 1e-5;  // of straight motions
  static constexpr int kMostInverse = 64;

  std::string robot;
  std::string base_link, tip_link;  ///< of a URDF's chain; empty: the root, the only leaf
  std::string srdf, joint_limits;   ///< files; empty: none
  std::map<std::string, std::string> packages;                ///< their folders by name
  std::vector<std::pair<std::string, std::string>> contacts;  ///< links that may touch
  std::map<std::string, double> joint_values;                 ///< of joints beside the chain
  bool visual = false;    ///< visual geometry stands for collision geometry that is missing
  bool bodiless = false;  ///< a robot without any body will do
  std::string held;       ///< file of what the tip holds; empty: nothing
  std::vector<std::string> held_touches;  ///< links that it may touch
  std::string scene;
  std::vector<double> start;  ///< a value for each joint
  std::string start_state;    ///< their name; empty: `start` says them
  std::vector<ArmGoal> goals;
  double position_tolerance = kLeastTolerance;  ///< metres, of poses
  double angle_tolerance = kLeastTolerance;     ///< radians, likewise
  double clearance = 0;                         ///< metres; 0: the sensor's own
  double duration = 0;                          ///< seconds; 0: as few as the limits allow
  double rate = 100;                            ///< samples of the trajectory a second
  int recheck = 0;                              ///< samples of the independent check
  bool straight = false;                        ///< the tip goes straight to the goal
  double straight_tolerance = 1e-3;             ///< metres off that line
  double straight_angle = 0.01;                 ///< radians off its even turn
  int inverse = 0;       ///< so many joint values that reach the goal, no motion; 0: a motion
  bool nearest = false;  ///< tell what is nearest to each other at start and end
};

int run_command(const ArmCommand& command);

}  // namespace lasius::tool
