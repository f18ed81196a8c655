#include "core/arm/spline.h"

#include <algorithm>
#include <cmath>

#include "kernels/base/power.h"

namespace lasius::arm {
namespace {

using Knot = Trajectory::Knot;

/// Times of the knots: the first and the last span are halved, an only one is cut in three.
std::vector<double> knot_times(const std::vector<double>& spans) {
  std::vector<double> times{0};
  const auto add = [&](double span) { times.push_back(times.back() + span); };
  const std::size_t last = spans.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const int parts = (i == 0) + (i == last) + 1;
    for (int p = 0; p < parts; ++p) add(spans[i] / parts);
  }
  return times;
}

/// One row of the system for the second derivatives at the inner knots:
/// below M[i-1] + middle M[i] + above M[i+1] = right.
struct Row {
  double below = 0, middle = 0, above = 0, right = 0;
};

/// Gauss elimination of a tridiagonal system (Thomas).
std::vector<double> solve(std::vector<Row>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double factor = rows[i].below / rows[i - 1].middle;
    rows[i].middle -= factor * rows[i - 1].above;
    rows[i].right -= factor * rows[i - 1].right;
  }
  std::vector<double> m(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const double next = i + 1 < rows.size() ? rows[i].above * m[i + 1] : 0;
    m[i] = (rows[i].right - next) / rows[i].middle;
  }
  return m;
}

/// Values and second derivatives of one joint at all knots; `passed` are the values to pass, the
/// first at knot 0, the next from knot 2 on, the last at the last knot.
///
/// Continuity of the first derivative at knot i:
///   h[i-1] M[i-1] + 2 (h[i-1] + h[i]) M[i] + h[i] M[i+1]
///     = 6 ((q[i+1] - q[i]) / h[i] - (q[i] - q[i-1]) / h[i-1])
/// At rest at both ends, M[0] = M[n] = 0, and the free values are q[1] = q[0] + h[0]^2 M[1] / 6 and
/// q[n-1] = q[n] + h[n-1]^2 M[n-1] / 6. Both are put into the rows in which they occur.
void solve_joint(const std::vector<double>& times, const std::vector<double>& passed,
                 std::vector<double>& q, std::vector<double>& m) {
  const std::size_t n = times.size() - 1;  // intervals, at least 3
  const auto h = [&](std::size_t i) { return times[i + 1] - times[i]; };
  q.assign(n + 1, 0);
  q[0] = q[1] = passed.front();
  q[n] = q[n - 1] = passed.back();
  for (std::size_t i = 1; i + 1 < passed.size(); ++i) q[i + 1] = passed[i];

  std::vector<Row> rows(n - 1);
  for (std::size_t i = 1; i < n; ++i) {
    Row& row = rows[i - 1];
    row = {h(i - 1), 2 * (h(i - 1) + h(i)), h(i),
           6 * ((q[i + 1] - q[i]) / h(i) - (q[i] - q[i - 1]) / h(i - 1))};
    // A free value adds its multiple of M to the row of every knot that sees it.
    const auto put = [&](std::size_t knot, double factor) {
      double& entry = knot == i ? row.middle : knot < i ? row.below : row.above;
      const double weight = knot == i ? 1 / h(i) + 1 / h(i - 1) : -1 / (knot < i ? h(i - 1) : h(i));
      entry += 6 * factor * weight;
    };
    if (i <= 2) put(1, h(0) * h(0) / 6);
    if (i + 2 >= n) put(n - 1, h(n - 1) * h(n - 1) / 6);
  }
  const std::vector<double> inner = solve(rows);
  m.assign(n + 1, 0);
  std::ranges::copy(inner, m.begin() + 1);
  q[1] = q[0] + h(0) * h(0) * m[1] / 6;
  q[n - 1] = q[n] + h(n - 1) * h(n - 1) * m[n - 1] / 6;
}

std::vector<Knot> empty_knots(const std::vector<double>& times, Eigen::Index joints) {
  std::vector<Knot> knots;
  knots.reserve(times.size());
  for (const double t : times)
    knots.push_back({t, JointVector::Zero(joints), JointVector::Zero(joints)});
  return knots;
}

/// One joint between two knots, by the time since the first.
struct Cubic {
  double h, q0, q1, m0, m1;

  Cubic(const Trajectory& trajectory, std::size_t i, std::size_t j) {
    const Knot &a = trajectory.knots()[i], &b = trajectory.knots()[i + 1];
    h = b.time - a.time;
    q0 = a.q[j];
    q1 = b.q[j];
    m0 = a.ddq[j];
    m1 = b.ddq[j];
  }
  double first() const { return (q1 - q0) / h - h * (2 * m0 + m1) / 6; }  // dq/dt at its start
  double velocity(double t) const { return first() + t * m0 + t * t * (m1 - m0) / (2 * h); }
  double value(double t) const {
    return q0 + t * (first() + t * (m0 / 2 + t * (m1 - m0) / (6 * h)));
  }
};

}  // namespace

Trajectory spline_through(const TimedWaypoints& course) {
  const std::vector<double> times = knot_times(course.spans);
  const Eigen::Index joints = course.points.front().size();
  auto knots = empty_knots(times, joints);
  std::vector<double> passed(course.points.size()), q, m;
  for (Eigen::Index j = 0; j < joints; ++j) {
    for (std::size_t i = 0; i < passed.size(); ++i) passed[i] = course.points[i][j];
    solve_joint(times, passed, q, m);
    for (std::size_t i = 0; i < knots.size(); ++i) {
      knots[i].q[j] = q[i];
      knots[i].ddq[j] = m[i];
    }
  }
  return Trajectory(std::move(knots));
}

Trajectory joined(std::span<const Trajectory> motions) {
  std::vector<Knot> knots;
  double begin = 0;
  for (const Trajectory& motion : motions) {
    for (Knot knot : motion.knots()) {
      if (!knots.empty() && knot.time == 0 && knot.ddq == knots.back().ddq) continue;
      knot.time += begin;
      knots.push_back(std::move(knot));
    }
    begin = knots.back().time;
  }
  return Trajectory(std::move(knots));
}

Trajectory stop_and_go(const TimedWaypoints& course) {
  std::vector<Trajectory> motions;
  for (std::size_t i = 0; i < course.spans.size(); ++i)
    motions.push_back(
        spline_through({{course.points[i], course.points[i + 1]}, {course.spans[i]}}));
  return joined(motions);
}

double needed_stretch(const Robot& robot, const Trajectory& trajectory, std::size_t i) {
  double most = 0;
  if (trajectory.knots()[i].time == trajectory.knots()[i + 1].time) return most;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Cubic cubic(trajectory, i, j);
    double speed = std::max(std::abs(cubic.velocity(0)), std::abs(cubic.velocity(cubic.h)));
    if (cubic.m0 * cubic.m1 < 0) {
      const double turn = cubic.h * cubic.m0 / (cubic.m0 - cubic.m1);
      speed = std::max(speed, std::abs(cubic.velocity(turn)));
    }
    const double force = std::max(std::abs(cubic.m0), std::abs(cubic.m1));
    most = std::max(
        {most, speed / robot.joints[j].velocity, std::sqrt(force / robot.joints[j].acceleration)});
    const double jerk = std::abs(cubic.m1 - cubic.m0) / cubic.h;
    if (robot.joints[j].jerk > 0 && jerk > 0)
      most = std::max(most, kernels::power(jerk / robot.joints[j].jerk, 1.0 / 3));
  }
  return most;
}

double needed_stretch(const Robot& robot, const Trajectory& trajectory) {
  double most = 0;
  for (std::size_t i = 0; i + 1 < trajectory.knots().size(); ++i)
    most = std::max(most, needed_stretch(robot, trajectory, i));
  return most;
}

Trajectory stretched(const Trajectory& trajectory, double factor) {
  std::vector<Knot> knots = trajectory.knots();
  for (Knot& knot : knots) {
    knot.time *= factor;
    for (double& a : knot.ddq) a /= factor * factor;
  }
  return Trajectory(std::move(knots));
}

std::pair<double, double> values_between(const Trajectory& trajectory, std::size_t i,
                                         std::size_t joint) {
  const Cubic cubic(trajectory, i, joint);
  double low = std::min(cubic.q0, cubic.q1), high = std::max(cubic.q0, cubic.q1);
  // Where the velocity a t^2 + b t + c is 0.
  const double a = (cubic.m1 - cubic.m0) / (2 * cubic.h), b = cubic.m0, c = cubic.first();
  const double root = b * b - 4 * a * c;
  if (root < 0) return {low, high};
  const double k = -0.5 * (b + std::copysign(std::sqrt(root), b));
  for (const double t : {k / a, c / k}) {
    if (!(t > 0 && t < cubic.h)) continue;
    low = std::min(low, cubic.value(t));
    high = std::max(high, cubic.value(t));
  }
  return {low, high};
}

}  // namespace lasius::arm
