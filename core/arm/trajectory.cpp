#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/arm/ends.h"
#include "core/arm/plan_check.h"
#include "core/arm/robot/kinematics.h"
#include "core/arm/robot/vec3.h"
#include "core/arm/spline.h"
#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/loop/run_status.h"
#include "kernels/base/random_stream.h"
#include "lasius/arm_trajectory.h"

namespace lasius::arm {
void check_clearance(const Sensor& sensor) {
  const double clearance = sensor.clearance();
  require_parameter(clearance >= Sensor::kLeastClearance, "the sensor's clearance", clearance,
                    "it must be at least 0.000001 metres");
}

void check_duration(double seconds) {
  require_parameter(seconds >= 0 && std::isfinite(seconds), "duration", seconds,
                    "it must be a number of seconds, or 0 for as few as the limits allow");
}

namespace {

using Waypoints = std::vector<JointVector>;

/// The sensor, its questions counted and limited, with a poll before each.
class CountedSensor {
 public:
  CountedSensor(const Sensor& sensor, const TrajectoryOptions& options)
      : sensor_(sensor),
        clearance_(sensor.clearance()),
        stop_(options.stop),
        poller_(stop_, kQuestions),
        most_(options.max_questions) {
    check_clearance(sensor);
  }

  bool motion_free(const JointRef& from, const JointRef& to) {
    if (poller_.stop_after(1) || (spent_ |= asked_ >= most_)) return false;
    ++asked_;
    const auto free = sensor_.try_motion(from, to, stop_);
    if (!free) poller_.stop_after(kQuestions);
    return free.value_or(false);
  }
  bool stopped() const noexcept { return poller_.stopped() || spent_; }
  /// Says in `result` how it ended, and what was asked.
  void finish(TrajectoryResult& result) const {
    end_run(result, poller_.cause(), spent_ ? Status::limit : Status::solved);
    if (spent_ && !poller_.stopped()) result.limit = Limit::questions;
    result.questions = asked_;
  }
  double clearance() const noexcept { return clearance_; }

 private:
  const Sensor& sensor_;
  double clearance_;
  static constexpr int kQuestions = 16;  // between two polls
  const StopCondition& stop_;
  Poller poller_;
  std::int64_t most_;
  std::int64_t asked_ = 0;
  bool spent_ = false;
};

/// From each waypoint on to one as far ahead as a straight motion goes, found by doubling and
/// halving; again until nothing is left out. A way that returns to a waypoint stays there.
Waypoints shortened(Waypoints way, CountedSensor& counted) {
  for (bool shorter = true; shorter && !counted.stopped();) {
    Waypoints kept{way.front()};
    for (std::size_t i = 0; i + 1 < way.size();) {
      std::size_t good = 1, bad = way.size() - i;  // ahead of i
      for (std::size_t step = 2; step < bad; step *= 2) {
        (counted.motion_free(way[i], way[i + step]) ? good : bad) = step;
      }
      while (bad - good > 1) {
        const std::size_t middle = good + (bad - good) / 2;
        (counted.motion_free(way[i], way[i + middle]) ? good : bad) = middle;
      }
      i += good;
      if (way[i] != kept.back()) kept.push_back(way[i]);
    }
    shorter = kept.size() < way.size();
    way = std::move(kept);
  }
  return way;
}

/// How far it is from one to the other: joint travel, or seconds where `quick`.
double far(const Robot& robot, bool quick, const JointVector& a, const JointVector& b) {
  double most = 0, sum = 0;
  for (int j = 0; j < robot.size(); ++j) {
    const double change = std::abs(b[j] - a[j]);
    most = std::max(most, change / robot.joints[j].velocity);
    sum += change * change;
  }
  return quick ? most : std::sqrt(sum);
}

/// Tries straight motions between two points drawn at random along the way (Geraerts & Overmars
/// 2007), and keeps those that are free and shorter than the way between.
Waypoints cut_at_random(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                        CountedSensor& counted) {
  constexpr std::uint32_t kUse = 2;  // of random streams
  constexpr double kLeastGain = 1e-3;
  kernels::RandomStream words(options.seed, 0, 0, kUse);
  for (int i = 0; i < options.shortcuts && way.size() > 2 && !counted.stopped(); ++i) {
    std::vector<double> until{0};
    for (std::size_t k = 1; k < way.size(); ++k)
      until.push_back(until.back() + far(robot, options.quick, way[k - 1], way[k]));
    std::array<double, 2> at{};
    for (double& place : at) place = (words.next() + 0.5) * 0x1p-32 * until.back();
    if (at[0] > at[1]) std::swap(at[0], at[1]);
    std::array<std::size_t, 2> after{};
    std::array<JointVector, 2> ends;
    for (int e = 0; e < 2; ++e) {
      const auto k = std::upper_bound(until.begin() + 1, until.end() - 1, at[e]) - until.begin();
      const double share = (at[e] - until[k - 1]) / (until[k] - until[k - 1]);
      after[e] = static_cast<std::size_t>(k);
      ends[e] = way[k - 1] + share * (way[k] - way[k - 1]);
    }
    const double gain = at[1] - at[0] - far(robot, options.quick, ends[0], ends[1]);
    if (after[0] == after[1] || !(gain > kLeastGain * until.back())) continue;
    if (!counted.motion_free(ends[0], ends[1])) continue;
    Waypoints shorter(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(after[0]));
    for (JointVector& end : ends) shorter.push_back(std::move(end));
    shorter.insert(shorter.end(), way.begin() + static_cast<std::ptrdiff_t>(after[1]), way.end());
    way = std::move(shorter);
  }
  return way;
}

/// The columns, none like the one before. @throws Error(invalid_parameter) outside of joint limits.
Waypoints waypoints_of(const Robot& robot, const Eigen::Ref<const Eigen::MatrixXd>& waypoints) {
  validate_but_corners(robot);
  for (Eigen::Index i = 0; i < waypoints.cols(); ++i) {
    const std::string fault =
        values_fault(robot, waypoints.col(i), "waypoint " + std::to_string(i + 1), 1e-9);
    if (!fault.empty()) throw invalid_parameter(fault, "bring it within them");
  }
  Waypoints way;
  for (const auto q : waypoints.colwise()) {
    if (way.empty() || q != way.back()) way.emplace_back(q);
  }
  return way;
}

Waypoints shorter_way(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                      CountedSensor& counted) {
  if (options.shortcut) way = shortened(std::move(way), counted);
  return cut_at_random(robot, options, std::move(way), counted);
}

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
    for (std::size_t i = 0; i < need.size(); ++i) {
      if (need[i] > 1) course.spans[i] *= std::min(need[i], 2.0);
    }
    trajectory = make(course);
  }
  double worst = 0;
  for (std::size_t i = 0; i + 1 < trajectory.knots().size(); ++i) {
    worst = std::max(worst, needed_stretch(robot, trajectory, i));
  }
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

/// A bound for how far any point of the arm moves when joint j turns by one radian.
std::vector<double> levers(const Robot& robot) {
  std::vector<double> most(robot.joints.size(), 0);
  for (int body = 1; body <= robot.size(); ++body) {
    double far = body == robot.size() ? length(from_eigen(robot.tip).position) : 0;
    far = std::max(far, extent(robot, body));
    const auto lever = levers_of(robot, body, far);
    for (int j = 0; j < body; ++j) most[j] = std::max(most[j], lever[j]);
  }
  return most;
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

/// A chord of a piece of length h is within h^2 / 8 max |ddq| of the joint's curve.
bool free_between(const Trajectory& trajectory, std::size_t i, const std::vector<double>& lever,
                  CountedSensor& counted) {
  const Trajectory::Knot &a = trajectory.knots()[i], &b = trajectory.knots()[i + 1];
  const double h = b.time - a.time;
  double bend = 0;
  for (std::size_t j = 0; j < lever.size(); ++j) {
    bend += lever[j] * std::max(std::abs(a.ddq[j]), std::abs(b.ddq[j]));
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(h * std::sqrt(bend / (8 * counted.clearance())))));
  JointVector from = a.q;
  for (int p = 1; p <= pieces; ++p) {
    JointVector to = p == pieces ? b.q : trajectory.at(a.time + h * p / pieces).q;
    if (!counted.motion_free(from, to)) return false;
    from = std::move(to);
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
                               const Trajectory& trajectory, const std::vector<double>& lever,
                               CountedSensor& counted) {
  std::vector<bool> faulty(course.spans.size(), false);
  for_each_piece(course, trajectory, [&](std::size_t i, std::size_t span) {
    if (within_values(robot, trajectory, i) && free_between(trajectory, i, lever, counted)) return;
    if (span > 0) faulty[span - 1] = true;
    faulty[span] = true;
    if (span + 1 < faulty.size()) faulty[span + 1] = true;
  });
  return faulty;
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

Eigen::MatrixXd shorten_way(const Robot& robot, const Sensor& sensor,
                            const Eigen::Ref<const Eigen::MatrixXd>& waypoints,
                            const TrajectoryOptions& options) {
  const Waypoints given = waypoints_of(robot, waypoints);
  CountedSensor counted(sensor, options);
  if (given.empty()) return waypoints;
  const Waypoints way = shorter_way(robot, options, given, counted);
  Eigen::MatrixXd columns(robot.size(), std::ssize(way));
  for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = way[i];
  return columns;
}

TrajectoryResult make_trajectory(const Robot& robot, const Sensor& sensor,
                                 const Eigen::Ref<const Eigen::MatrixXd>& waypoints,
                                 const TrajectoryOptions& options) {
  constexpr int kRounds = 6;
  check_duration(options.duration);
  const Waypoints given = waypoints_of(robot, waypoints);
  TrajectoryResult result;
  if (given.empty()) return result;
  CountedSensor counted(sensor, options);
  const Waypoints way = shorter_way(robot, options, given, counted);
  result.waypoints = static_cast<int>(way.size());
  if (way.size() == 1) {
    counted.finish(result);
    result.trajectory = Trajectory({{0, way[0], JointVector::Zero(robot.size())}});
    return result;
  }
  TimedWaypoints course{way, {}};
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    course.spans.push_back(fastest(robot, way[i], way[i + 1]));
  }
  const TimedWaypoints straight = course;
  const std::vector<double> lever = levers(robot);
  bool found = false;
  for (int round = 0; round < kRounds && !found && !counted.stopped(); ++round) {
    result.trajectory = within_limits(robot, course, spline_through);
    const auto faulty = faulty_spans(robot, course, result.trajectory, lever, counted);
    found = std::ranges::find(faulty, true) == faulty.end();
    if (!found) course = refined(course, faulty);
  }
  // Rest at every waypoint also where there was no time to check: straight motions are known.
  if (!found) {
    course = straight;
    result.trajectory = within_limits(robot, course, stop_and_go);
    result.stops = true;
  }
  if (options.duration > result.trajectory.duration())
    result.trajectory = slowed(result.trajectory, options.duration);
  counted.finish(result);
  return result;
}

}  // namespace lasius::arm
