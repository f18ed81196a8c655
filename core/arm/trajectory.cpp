#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/plan_check.h"
#include "core/arm/rounded_motion.h"
#include "core/arm/spline.h"
#include "core/base/invalid_parameter.h"

namespace lasius::arm {
void check_duration(double seconds) {
  require_parameter(seconds >= 0 && std::isfinite(seconds), "duration", seconds,
                    "it must be a number of seconds, or 0 for as few as the limits allow");
}

namespace {

/// The fastest that the joints' velocities allow on the straight.
double fastest(const Robot& robot, const JointVector& a, const JointVector& b) {
  return std::max(1e-6, far(robot, true, a, b));
}

/// Calls visit(i, span) for each piece of a trajectory, from knot i to the next, and the span of
/// the course that it lies in.
template <class Visit>
void for_each_piece(const TimedWaypoints& course, const Trajectory& trajectory,
                    const Visit& visit) {
  const auto& knots = trajectory.knots();
  std::size_t span = 0;
  double until = course.spans[0];
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double middle = 0.5 * (knots[i].time + knots[i + 1].time);
    while (middle > until && span + 1 < course.spans.size()) until += course.spans[++span];
    visit(i, span);
  }
}

/// Stretches spans until the limits hold nearly everywhere, and then all of them until they do.
template <class Make>
Trajectory within_limits(const Robot& robot, TimedWaypoints& course, const Make& make) {
  constexpr int kRounds = 30;
  Trajectory trajectory = make(course);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> need(course.spans.size(), 0);
    for_each_piece(course, trajectory, [&](std::size_t i, std::size_t span) {
      need[span] = std::max(need[span], needed_stretch(robot, trajectory, i));
    });
    if (*std::ranges::max_element(need) <= 1.02) break;
    for (std::size_t i = 0; i < need.size(); ++i)
      if (need[i] > 1) course.spans[i] *= std::min(need[i], 2.0);
    trajectory = make(course);
  }
  const double worst = needed_stretch(robot, trajectory);
  constexpr double kMargin = 1 + 1e-12;  // for rounding
  for (double& span : course.spans) span *= worst * kMargin;
  return stretched(trajectory, worst * kMargin);
}

/// The motion slowed to take exactly `duration` seconds.
Trajectory slowed(const Trajectory& fast, double duration) {
  auto knots = stretched(fast, duration / fast.duration()).knots();
  knots.back().time = duration;
  return Trajectory(std::move(knots));
}

bool within_values(const Robot& robot, const Trajectory& trajectory, std::size_t i) {
  constexpr double kTolerance = 1e-12;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const auto [low, high] = values_between(trajectory, i, j);
    if (low < robot.joints[j].low - kTolerance || high > robot.joints[j].high + kTolerance)
      return false;
  }
  return true;
}

/// Halves the marked spans of a course, each new point half way along the straight motion.
TimedWaypoints refined(const TimedWaypoints& course, const std::vector<bool>& marked) {
  TimedWaypoints finer;
  finer.points.push_back(course.points.front());
  for (std::size_t i = 0; i < course.spans.size(); ++i) {
    const auto &a = course.points[i], &b = course.points[i + 1];
    if (marked[i]) {
      finer.points.push_back(0.5 * (a + b));
      finer.spans.push_back(0.5 * course.spans[i]);
    }
    finer.points.push_back(b);
    finer.spans.push_back((marked[i] ? 0.5 : 1) * course.spans[i]);
  }
  return finer;
}

/// Spans of the course in which the spline is not free, and their neighbours.
std::vector<bool> faulty_spans(const Robot& robot, const TimedWaypoints& course,
                               const Trajectory& trajectory, CountedSensor& counted) {
  std::vector<bool> faulty(course.spans.size(), false);
  const auto& knots = trajectory.knots();
  for_each_piece(course, trajectory, [&](std::size_t i, std::size_t span) {
    if (within_values(robot, trajectory, i) &&
        counted.chords_free(trajectory, knots[i].time, knots[i + 1].time))
      return;
    if (span > 0) faulty[span - 1] = true;
    faulty[span] = true;
    if (span + 1 < faulty.size()) faulty[span + 1] = true;
  });
  return faulty;
}

/// A spline through the way, with more knots where it is not free; `stops` where that fails.
Trajectory spline_motion(const Robot& robot, const Waypoints& way, CountedSensor& counted,
                         bool& stops) {
  constexpr int kRounds = 6;
  TimedWaypoints course{way, {}};
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    course.spans.push_back(fastest(robot, way[i], way[i + 1]));
  TimedWaypoints straight = course;
  for (int round = 0; round < kRounds && !counted.stopped(); ++round) {
    Trajectory trajectory = within_limits(robot, course, spline_through);
    const auto faulty = faulty_spans(robot, course, trajectory, counted);
    if (std::ranges::find(faulty, true) == faulty.end()) return trajectory;
    course = refined(course, faulty);
  }
  // Rest at every waypoint also where there was no time to check: straight motions are known.
  stops = true;
  return within_limits(robot, straight, stop_and_go);
}

}  // namespace

Trajectory::Trajectory(std::vector<Knot> knots) : knots_(std::move(knots)) {}

Trajectory::State Trajectory::at(double time) const {
  // At rest at both ends, whatever rounding says.
  const auto at_rest = [](const Knot& knot) {
    const JointVector none = JointVector::Zero(knot.q.size());
    return State{knot.q, none, none};
  };
  if (!(time > 0)) return at_rest(knots_.front());
  if (time >= duration()) return at_rest(knots_.back());
  const auto after = std::ranges::upper_bound(knots_, time, {}, &Knot::time);
  const Knot &a = after[-1], &b = *after;
  const double h = b.time - a.time, t = time - a.time;
  const Eigen::Index joints = a.q.size();
  State state{JointVector(joints), JointVector(joints), JointVector(joints)};
  for (Eigen::Index j = 0; j < joints; ++j) {
    const double bend = (b.ddq[j] - a.ddq[j]) / h;
    const double first = (b.q[j] - a.q[j]) / h - h * (2 * a.ddq[j] + b.ddq[j]) / 6;
    state.q[j] = a.q[j] + t * (first + t * (a.ddq[j] / 2 + t * bend / 6));
    state.dq[j] = first + t * (a.ddq[j] + t * bend / 2);
    state.ddq[j] = a.ddq[j] + t * bend;
  }
  return state;
}

TrajectoryResult make_trajectory(const Robot& robot, const Sensor& sensor,
                                 const Eigen::Ref<const Eigen::MatrixXd>& waypoints,
                                 const TrajectoryOptions& options) {
  check_duration(options.duration);
  const Waypoints given = waypoints_of(robot, waypoints);
  TrajectoryResult result;
  if (given.empty()) return result;
  CountedSensor counted(robot, sensor, options);
  const bool splines = options.timing == Timing::splines;
  TrajectoryOptions cuts = options;
  cuts.quick &= splines;  // joint travel first
  const Waypoints way = shorter_way(robot, cuts, given, counted);
  result.waypoints = static_cast<int>(way.size());
  if (way.size() == 1)
    result.trajectory = Trajectory({{0, way[0], JointVector::Zero(robot.size())}});
  else if (splines)
    result.trajectory = spline_motion(robot, way, counted, result.stops);
  else
    result.trajectory = rounded_motion(robot, way, counted, result.stops);
  if (options.quick && !splines && way.size() > 2 && !counted.stopped()) {
    const Waypoints quick = quicker_way(robot, options, way, counted, [&](const Waypoints& other) {
      return seconds_at_best(robot, other);
    });
    bool stops = false;
    Trajectory motion;
    if (!counted.stopped()) motion = rounded_motion(robot, quick, counted, stops);
    if (!motion.empty() && motion.duration() < result.trajectory.duration()) {
      result.trajectory = std::move(motion);
      result.waypoints = static_cast<int>(quick.size());
      result.stops = stops;
    }
  }
  if (way.size() > 1 && options.duration > result.trajectory.duration())
    result.trajectory = slowed(result.trajectory, options.duration);
  counted.finish(result);
  return result;
}

}  // namespace lasius::arm
