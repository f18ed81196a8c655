#include "core/arm/ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "kernels/base/random_stream.h"

namespace lasius::arm {
namespace {

std::string text(Vec3 p) {
  return number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z);
}

/// The normal of the plane in which the tip moves, whatever the joints do; nothing where it moves
/// in all of space, or along a line.
std::optional<Vec3> plane_of(const Kinematics& arm, const Kinematics::Poses& poses) {
  constexpr double kParallel = 1e-9;
  int first = 0;
  while (first < arm.size() && arm.slides(first)) ++first;
  if (first == arm.size()) return std::nullopt;
  const Vec3 normal = arm.axis(first, poses);
  for (int j = 0; j < arm.size(); ++j) {
    const Vec3 axis = arm.axis(j, poses);
    const double off = arm.slides(j) ? std::abs(dot(normal, axis)) : length(cross(normal, axis));
    if (off > kParallel) return std::nullopt;
  }
  return normal;
}

std::string limits_fault(const Robot& robot, const JointVector& q, const std::string& what, int j) {
  const Joint& joint = robot.joints[j];
  return what + ": " + joint_name(robot, j) + " is " + number_text(q[j]) + ", its limits are " +
         number_text(joint.low) + " .. " + number_text(joint.high);
}

/// Turned by whole turns as near to `start` as limits allow: all joints, or those turning freely.
void turn_towards(const Robot& robot, const JointVector& start, bool all, JointVector& q) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (joint.kind == Joint::Kind::prismatic || !(all || joint.continuous)) continue;
    const double turned = q[j] + kTurn * std::round((start[j] - q[j]) / kTurn);
    if (turned >= joint.low && turned <= joint.high) q[j] = turned;
  }
}

/// Where attempt `number` begins: at the start, at the start bent, then anywhere.
JointVector first_guess(const Robot& robot, const Kinematics& arm, const JointVector& start,
                        std::uint64_t seed, int goal, int number) {
  constexpr double kBend = 0.3;
  if (number >= 3)
    return random_values(robot, start, seed, static_cast<std::uint32_t>(goal),
                         static_cast<std::uint32_t>(number));
  JointVector q = start;
  arm.bend({q.data(), static_cast<std::size_t>(q.size())}, number == 2 ? -kBend : number * kBend);
  return q;
}

}  // namespace

std::pair<std::string, std::string> metres(double length, double than) {
  std::array<char, 32> digits, others;
  for (int count = 4; count <= 17; ++count) {
    std::snprintf(digits.data(), digits.size(), "%.*g", count, length);
    std::snprintf(others.data(), others.size(), "%.*g", count, than);
    if (std::string_view(digits.data()) != others.data()) break;
  }
  return {digits.data(), others.data()};
}

std::string values_fault(const Robot& robot, const JointVector& q, const std::string& what,
                         double tolerance) {
  if (q.size() != robot.size())
    return what + " has " + std::to_string(q.size()) + " joint values, the robot needs " +
           std::to_string(robot.size());
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!(q[j] >= joint.low - tolerance && q[j] <= joint.high + tolerance))
      return limits_fault(robot, q, what, j);
  }
  return {};
}

JointVector within_limits(const Robot& robot, JointVector q, const std::string& what,
                          std::vector<std::string>& notes) {
  if (q.size() != robot.size()) return q;
  for (int j = 0; j < robot.size(); ++j) {
    const double limit = std::clamp(q[j], robot.joints[j].low, robot.joints[j].high);
    if (q[j] == limit || !(std::abs(q[j] - limit) <= Request::kLimitTolerance)) continue;
    notes.push_back(limits_fault(robot, q, what, j) + ": taken at the limit");
    q[j] = limit;
  }
  return q;
}

JointVector random_values(const Robot& robot, const JointVector& start, std::uint64_t seed,
                          std::uint32_t series, std::uint32_t number) {
  constexpr std::uint32_t kUse = 1;  // of random streams: the ants' is 0
  kernels::RandomStream words(seed, series, number, kUse);
  JointVector q(robot.size());
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const double half = joint.continuous ? std::numbers::pi : 0.5 * (joint.high - joint.low);
    const double middle = joint.continuous ? start[j] : 0.5 * (joint.low + joint.high);
    q[j] =
        std::clamp(middle + half * (2 * (words.next() + 0.5) * 0x1p-32 - 1), joint.low, joint.high);
  }
  return q;
}

double joint_travel(const JointRef& a, const JointRef& b) {
  double sum = 0;
  for (Eigen::Index j = 0; j < a.size(); ++j) sum += (b[j] - a[j]) * (b[j] - a[j]);
  return std::sqrt(sum);
}

double largest_change(const JointRef& a, const JointRef& b) {
  double most = 0;
  for (Eigen::Index j = 0; j < a.size(); ++j) most = std::max(most, std::abs(a[j] - b[j]));
  return most;
}

TipTarget tip_target(const Goal& goal) {
  const bool any = goal.kind == Goal::Kind::position;
  return {from_eigen(goal.target), any ? Goal::kTolerance : goal.position_tolerance,
          any ? 2 * std::numbers::pi : goal.angle_tolerance};
}

bool is_at(const Robot& robot, const Kinematics& arm, const Goal& goal, const JointVector& q) {
  if (goal.kind != Goal::Kind::joints) return arm.is_at(tip_target(goal), as_span(q));
  double most = 0;
  for (int j = 0; j < robot.size(); ++j) {
    const double change = goal.values[j] - q[j];
    most = std::max(
        most, std::abs(robot.joints[j].continuous ? std::remainder(change, 2 * std::numbers::pi)
                                                  : change));
  }
  return most <= Goal::kTolerance;
}

std::string goal_fault(const Robot& robot, const Kinematics& arm, std::span<const double> start,
                       const Goal& goal) {
  if (goal.kind == Goal::Kind::joints) return values_fault(robot, goal.values, "goal");
  const TipTarget target = tip_target(goal);
  if (!(target.position_tolerance >= Goal::kTolerance &&
        target.angle_tolerance >= Goal::kTolerance))
    return "goal: its tolerances must be at least " + number_text(Goal::kTolerance);
  const Eigen::Matrix3d turn = goal.target.linear();
  if (!((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6 &&
        turn.determinant() > 0))
    return "goal: its orientation is no rotation";
  const Vec3 at = target.at.position;
  const std::string name = "goal " + text(at);
  const double far = distance(at, arm.shoulder());
  if (!(far <= arm.reach() + target.position_tolerance)) {
    const auto [away, most] = metres(far, arm.reach());
    return name + " is outside: it is " + away + " m from the arm's first joint, the arm reaches " +
           most + " m";
  }
  if (far < arm.least_reach() - target.position_tolerance) {
    const auto [away, least] = metres(far, arm.least_reach());
    return name + " is out of reach: it is " + away +
           " m from the arm's first joint, the arm folds to " + least + " m";
  }
  Kinematics::Poses poses;
  arm.place(start, poses);
  if (const auto normal = plane_of(arm, poses)) {
    const double off = std::abs(dot(*normal, at - arm.tip(poses)));
    if (off > target.position_tolerance)
      return name + " is out of reach: the joints move the tip in one plane, the goal is " +
             metres(off, 0).first + " m off it";
  }
  return {};
}

std::vector<End> find_ends(const Robot& robot, const Kinematics& arm, const Request& request,
                           std::span<const int> goals, std::uint64_t seed, int first, int attempts,
                           int most, std::span<const End> known) {
  std::vector<End> ends;
  const JointVector& start = request.start;
  Poller poller(request.stop, 1);
  const auto add = [&](JointVector q, int goal) {
    Kinematics::Poses poses;
    arm.place(as_span(q), poses);
    ends.push_back({std::move(q), goal, arm.tip(poses)});
  };
  for (const int g : goals) {
    const Goal& goal = request.goals[g];
    if (goal.kind == Goal::Kind::joints) {
      if (first > 0) continue;
      JointVector q = goal.values;
      turn_towards(robot, start, false, q);
      add(std::move(q), g);
      continue;
    }
    const TipTarget target = tip_target(goal);
    const std::size_t before = ends.size();
    for (int i = first; i < first + attempts && ends.size() < before + most; ++i) {
      if (poller.stop_after(1)) break;
      JointVector q = first_guess(robot, arm, start, seed, g, i);
      const std::span<double> values(q.data(), static_cast<std::size_t>(q.size()));
      if (!arm.reach_pose(target, values)) continue;
      JointVector nearest = q;
      turn_towards(robot, start, true, nearest);
      if (arm.is_at(target, as_span(nearest))) q = nearest;
      const auto same = [&](const End& other) {
        return other.goal == g && largest_change(other.q, q) < kSamePosture;
      };
      if (std::ranges::none_of(ends, same) && std::ranges::none_of(known, same))
        add(std::move(q), g);
    }
  }
  std::ranges::stable_sort(ends, [&](const End& a, const End& b) {
    return joint_travel(a.q, start) < joint_travel(b.q, start);
  });
  return ends;
}

}  // namespace lasius::arm
