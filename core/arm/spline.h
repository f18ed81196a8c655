// Cubic splines through joint vectors, at rest at both ends.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "lasius/arm/trajectory.h"

namespace lasius::arm {

/// Joint vectors to pass, and the time between each and the next.
struct TimedWaypoints {
  std::vector<JointVector> points;  // at least 2
  std::vector<double> spans;        // one less, seconds above 0
};

/// The spline through the course: velocity and acceleration are 0 at both ends, for which the first
/// and the last interval (or the only one) get a free knot each.
Trajectory spline_through(const TimedWaypoints& course);

/// One after another, from rest to rest; where the acceleration jumps knots stand twice.
/// Precondition: each begins where the one before ends.
Trajectory joined(std::span<const Trajectory> motions);

/// Straight from point to point, at rest at each.
Trajectory stop_and_go(const TimedWaypoints& course);

/// How much longer interval `i` between two knots had to be for limits of velocity, acceleration
/// and jerk to hold in it; 1 where one is just met, 0 where it takes no time.
double needed_stretch(const Robot& robot, const Trajectory& trajectory, std::size_t i);

/// The largest of all intervals.
double needed_stretch(const Robot& robot, const Trajectory& trajectory);

/// The motion `factor` times slower: velocities by 1 / factor, joint values unchanged.
Trajectory stretched(const Trajectory& trajectory, double factor);

/// Least and largest value of a joint between knots i and i + 1.
std::pair<double, double> values_between(const Trajectory& trajectory, std::size_t i,
                                         std::size_t joint);

}  // namespace lasius::arm
