// Joint values that bring the tip's frame to a pose.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/arm/robot/kinematics.h"
#include "kernels/base/power.h"

namespace lasius::arm {
namespace {

/// A position and a turn, or what they change by.
using Six = std::array<double, 6>;
/// What a frame changes by where a joint does, by joint.
using Columns = std::array<Six, Robot::kMaxJoints>;

/// What is left of an error beyond its tolerance. Steps aim a little within it.
double share_left(double size, double tolerance) noexcept {
  constexpr double kWithin = 0.9;
  return size > kWithin * tolerance ? 1 - kWithin * tolerance / size : 0;
}

/// Solves (J J^T + damping) x = b by Cholesky, in place of b, over `rows` rows.
void solve(const Columns& column, const std::array<bool, Robot::kMaxJoints>& held, int joints,
           int rows, double damping, Six& b) noexcept {
  std::array<Six, 6> l{};
  for (int j = 0; j < joints; ++j) {
    if (held[j]) continue;
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c <= r; ++c) l[r][c] += column[j][r] * column[j][c];
    }
  }
  for (int r = 0; r < rows; ++r) {
    l[r][r] += damping;
    for (int c = 0; c <= r; ++c) {
      for (int k = 0; k < c; ++k) l[r][c] -= l[r][k] * l[c][k];
      l[r][c] = r == c ? std::sqrt(std::max(l[r][r], 1e-300)) : l[r][c] / l[c][c];
    }
  }
  for (int r = 0; r < rows; ++r) {
    for (int k = 0; k < r; ++k) b[r] -= l[r][k] * b[k];
    b[r] /= l[r][r];
  }
  for (int r = rows - 1; r >= 0; --r) {
    for (int k = r + 1; k < rows; ++k) b[r] -= l[k][r] * b[k];
    b[r] /= l[r][r];
  }
}

/// The way of a frame to its target, and its turn, what the tolerances leave of them: of six rows
/// or of the way's three. A radian counts as `arm` metres.
Six error_of(const TipTarget& target, const Placement& at, int rows, double arm) noexcept {
  const Vec3 way = target.at.position - at.position;
  const double left = share_left(length(way), target.position_tolerance);
  Six error{left * way.x, left * way.y, left * way.z};
  if (rows < 6) return error;
  const Vec3 turn = turn_between(at.rotation, target.at.rotation);
  const double more = arm * share_left(length(turn), target.angle_tolerance);
  error[3] = more * turn.x;
  error[4] = more * turn.y;
  error[5] = more * turn.z;
  return error;
}

Columns columns_of(const Kinematics& joints, const Kinematics::Poses& poses, Vec3 position,
                   double arm) noexcept {
  Columns column{};
  for (int j = 0; j < joints.size(); ++j) {
    const Vec3 along = joints.axis(j, poses);
    const bool slides = joints.slides(j);
    const Vec3 v = slides ? along : cross(along, position - poses[j].position);
    column[j] = {v.x, v.y, v.z};
    if (slides) continue;
    column[j][3] = arm * along.x;
    column[j][4] = arm * along.y;
    column[j][5] = arm * along.z;
  }
  return column;
}

/// One damped step against an error. A joint that it would push past its limit is held there, and
/// the step taken anew.
void step(const Kinematics& joints, const Columns& column, int rows, Six error,
          std::span<double> q) noexcept {
  constexpr double kDamping = 0.02;     // of the squared error
  constexpr double kLongestStep = 0.5;  // radians or metres
  double square = 0;
  for (int r = 0; r < rows; ++r) square += error[r] * error[r];
  std::array<bool, Robot::kMaxJoints> held{};
  JointArray change{};
  for (bool pushed = true; pushed;) {
    Six force = error;
    solve(column, held, joints.size(), rows, kDamping * square + 1e-12, force);
    double longest = 0;
    for (int j = 0; j < joints.size(); ++j) {
      change[j] = 0;
      for (int r = 0; r < rows && !held[j]; ++r) change[j] += column[j][r] * force[r];
      longest = std::max(longest, std::abs(change[j]));
    }
    pushed = false;
    for (int j = 0; j < joints.size(); ++j) {
      if (longest > kLongestStep) change[j] *= kLongestStep / longest;
      const double next = q[j] + change[j];
      if (held[j] || (next >= joints.low(j) && next <= joints.high(j))) continue;
      const double limit = std::clamp(next, joints.low(j), joints.high(j));
      for (int r = 0; r < rows; ++r) error[r] -= (limit - q[j]) * column[j][r];
      q[j] = limit;
      held[j] = pushed = true;
    }
  }
  for (int j = 0; j < joints.size(); ++j) q[j] += held[j] ? 0 : change[j];
}

}  // namespace

Vec3 turn_between(const Rotation& from, const Rotation& to) noexcept {
  Rotation turn;  // to * from^T
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      turn[3 * i + j] = to[3 * i] * from[3 * j] + to[3 * i + 1] * from[3 * j + 1] +
                        to[3 * i + 2] * from[3 * j + 2];
    }
  }
  const Vec3 twice{turn[7] - turn[5], turn[2] - turn[6], turn[3] - turn[1]};  // 2 sin(angle) axis
  const double sine = 0.5 * length(twice), cosine = 0.5 * (turn[0] + turn[4] + turn[8] - 1);
  const double angle = kernels::angle_between(1, 0, cosine, sine);
  if (sine > 1e-6) return (0.5 * angle / sine) * twice;
  if (cosine > 0) return 0.5 * twice;
  // Half a turn: the longest column of turn + 1 lies along the axis.
  Vec3 axis;
  for (int i = 0; i < 3; ++i) {
    Vec3 column{turn[i], turn[3 + i], turn[6 + i]};
    (i == 0 ? column.x : i == 1 ? column.y : column.z) += 1;
    if (length(column) > length(axis)) axis = column;
  }
  return (angle / length(axis)) * axis;
}

bool Kinematics::is_at(const TipTarget& target, std::span<const double> q) const noexcept {
  Poses poses;
  place(q, poses);
  const Placement at = tip_frame(poses);
  return distance(target.at.position, at.position) <= target.position_tolerance &&
         (target.angle_tolerance >= std::numbers::pi ||
          length(turn_between(at.rotation, target.at.rotation)) <= target.angle_tolerance);
}

bool Kinematics::reach_pose(const TipTarget& target, std::span<double> q) const noexcept {
  constexpr int kMostSteps = 100;
  if (distance(target.at.position, shoulder()) > reach_ + target.position_tolerance) return false;
  const int rows = target.angle_tolerance >= std::numbers::pi ? 3 : 6;
  const double arm = 0.25 * reach_;  // metres that a radian of orientation counts as
  Poses poses;
  for (int count = 0; count < kMostSteps; ++count) {
    if (is_at(target, q)) return true;
    place(q, poses);
    const Placement at = tip_frame(poses);
    step(*this, columns_of(*this, poses, at.position, arm), rows, error_of(target, at, rows, arm),
         q);
  }
  return is_at(target, q);
}

}  // namespace lasius::arm
