// Where a way may end: what is proven of goals, and joint values that reach them.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/arm/robot/kinematics.h"
#include "lasius/arm/plan.h"

namespace lasius::arm {

/// Joint values that reach a goal of the request.
struct End {
  JointVector q;
  int goal = 0;  // index of the request's goals
  Vec3 tip;      // where it is then, metres
};

/// Two lengths for a message, the first with as many digits as tell it from the second.
std::pair<std::string, std::string> metres(double length, double than);

/// Why these are no joint values within the limits, by more than `tolerance`; empty where they are.
/// `what` names them, "start" say.
std::string values_fault(const Robot& robot, const JointVector& q, const std::string& what,
                         double tolerance = 0);

/// Values that are outside of the limits by no more than Request::kLimitTolerance, taken at them; a
/// note of each is added. `what` as of values_fault.
JointVector within_limits(const Robot& robot, JointVector q, const std::string& what,
                          std::vector<std::string>& notes);

/// Why no joint values within the limits reach the goal from `start`: a proof. Empty without one.
std::string goal_fault(const Robot& robot, const Kinematics& arm, std::span<const double> start,
                       const Goal& goal);

/// What a goal asks of the tip. Precondition: it is none of joint values.
TipTarget tip_target(const Goal& goal);

/// True when the arm reaches the goal with these values; joints that turn freely by any turns.
bool is_at(const Robot& robot, const Kinematics& arm, const Goal& goal, const JointVector& q);

/// Postures that reach the goals of these numbers, those nearest to the start first: of each, what
/// inverse kinematics makes of the start, of the start bent, and of random values within the
/// limits, `attempts` in all from number `first` on, as long as there are less than `most`. No two
/// are within kSamePosture, nor of one that is `known`; joints that may turn by whole turns are as
/// near to the start as they can. Those so far where the request is told to stop.
std::vector<End> find_ends(const Robot& robot, const Kinematics& arm, const Request& request,
                           std::span<const int> goals, std::uint64_t seed, int first, int attempts,
                           int most, std::span<const End> known = {});

/// Joint values of which none differs by more are one posture.
inline constexpr double kSamePosture = 0.2;  // radians or metres

/// Values drawn within the limits, by number; of a joint turning freely within a turn of `start`.
JointVector random_values(const Robot& robot, const JointVector& start, std::uint64_t seed,
                          std::uint32_t series, std::uint32_t number);

/// The length of the straight joint-space line: the root of the sum of squares.
double joint_travel(const JointRef& a, const JointRef& b);

/// Largest change of a joint, radians or metres.
double largest_change(const JointRef& a, const JointRef& b);

}  // namespace lasius::arm
