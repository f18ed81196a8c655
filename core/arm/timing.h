// The least time in which a path can be followed.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/arm/blends.h"
#include "lasius/arm/trajectory.h"

namespace lasius::arm {

/// A motion along a run, and from when to when it is on each of its parabolas.
struct TimedRun {
  Trajectory motion;
  std::vector<std::array<double, 2>> blends;
};

/// At rest at both ends, in the least time that the joints' velocities and accelerations allow:
/// reachability, as in Pham & Pham, *A New Approach to Time-Optimal Path Parameterization Based on
/// Reachability Analysis*, IEEE Transactions on Robotics 34 (3), 2018. With x = (ds/dt)^2 and
/// u = d2s/dt2, of which x is linear in s with slope 2 u, joint j has the velocity q'_j sqrt(x) and
/// the acceleration q'_j u + q''_j x. Edges are taken exactly. A parabola is cut in `steps` of one
/// u each, with the limits at both ends of each: q'' is constant, so acceleration is linear in s
/// between. In a step the motion is two pieces of constant acceleration that are where the path is,
/// and as fast, at both ends. Accelerations jump between pieces: knots stand there twice.
TimedRun in_least_time(const Robot& robot, const PathRun& run, int steps);

/// The mean of a motion over the last so many seconds: accelerations are continuous and go evenly
/// between knots, no limit is broken that held before, and jerk is what the acceleration changed in
/// that time, divided by it. That time is as short as the limits of jerk allow; where it pays, the
/// motion is slowed first. On edges it stays on them. As it is where no joint that moves has a
/// limit of jerk. Once `stopped`, which is asked after each mean, says so, the best so far is
/// taken, slow enough for the limits. Precondition: accelerations are constant between knots.
TimedRun smoothed(const Robot& robot, const TimedRun& run, const std::function<bool()>& stopped);

}  // namespace lasius::arm
