// A motion as tables of other programs have it: states at times.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "lasius/arm/trajectory.h"

namespace lasius::tool {

/// Most samples of a motion.
inline constexpr double kMostSamples = 1e6;

/// The names of a robot's joints; q1, q2.. in their place in the chain for those without one.
std::vector<std::string> joint_names(const arm::Robot& robot);

/// The names of its links; one without a name is told by what it moves with.
std::vector<std::string> link_names(const arm::Robot& robot);

/// Samples a second of a motion: as many as wanted, kMostSamples in all at most.
double sample_rate(const arm::Trajectory& trajectory, double wanted);

/// Times at which a motion is told: so many a second, and its end. Precondition: not empty.
std::vector<double> sample_times(const arm::Trajectory& trajectory, double wanted);

/// Header, and a row a sample: t, the joints' values by name, NAME_velocity and NAME_acceleration
/// of each, x, y, z of the tip.
void write_csv(std::ostream& out, const arm::Robot& robot, const arm::Trajectory& trajectory,
               double rate);

/// A ROS message trajectory_msgs/JointTrajectory.
void write_ros_trajectory(std::ostream& out, const arm::Robot& robot,
                          const arm::Trajectory& trajectory, double rate);

}  // namespace lasius::tool
