#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/arm/contact/motion_bound.h"
#include "core/arm/ends.h"
#include "core/arm/plan_check.h"
#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/loop/run_status.h"
#include "lasius/arm/plan.h"

namespace lasius::arm {
namespace {

/// The way of a frame: straight, and turning evenly.
class FrameLine {
 public:
  FrameLine(const Placement& from, const Placement& to)
      : from_(from), way_(to.position - from.position) {
    const Vec3 turn = turn_between(from.rotation, to.rotation);
    angle_ = length(turn);
    axis_ = angle_ > 0 ? (1 / angle_) * turn : Vec3{0, 0, 1};
  }
  Placement at(double s) const {
    return {rotation_about(axis_, s * angle_) * from_.rotation, from_.position + s * way_};
  }
  /// The place on it that a frame is at, told by what goes further in its tolerance.
  double share_of(const Placement& frame, const TipLineOptions& options) const {
    double share = 0;
    if (length(way_) * options.angle_tolerance >= angle_ * options.tolerance) {
      if (length(way_) > 0) share = dot(frame.position - from_.position, way_) / dot(way_, way_);
    } else {
      share = dot(turn_between(from_.rotation, frame.rotation), axis_) / angle_;
    }
    return std::clamp(share, 0.0, 1.0);
  }

 private:
  Placement from_;
  Vec3 way_, axis_;
  double angle_;
};

/// How far the tip gets off the chord between two postures, metres, and off its even turn, radians,
/// while the joints go straight: by bounds of the second derivatives, docs/theory.md.
struct Deviation {
  double off, turned;
  double turn;  // that the chord makes at most
};
Deviation deviation(const Kinematics& arm, const JointVector& a, const JointVector& b) {
  const JointVector middle = 0.5 * (a + b), change = b - a;
  Kinematics::Poses poses;
  arm.place(as_span(middle), poses);
  MotionBound bound(arm);
  bound.set(as_span(change), 0.5, poses);
  const RelativeMotion motion = bound.of(arm.size(), 0);
  const double out = distance(arm.tip(poses), poses[arm.size() - 1].position);
  constexpr double kCurved = 2.05;  // of turns up to kMostTurn
  return {(motion.far + motion.spread * out) / 8, kCurved * motion.spread / 8, motion.turning};
}

/// A sensor that calls a curve free only where the tip keeps to the line, too.
class LineSensor final : public Sensor {
 public:
  /// All must outlive it.
  LineSensor(const Robot& robot, const Kinematics& arm, const Sensor& sensor, const FrameLine& way,
             const TipLineOptions& options)
      : arm_(arm), sensor_(sensor), way_(way), options_(options) {
    levers_ = levers_of(robot, robot.size(), length(from_eigen(robot.tip).position));
  }
  bool position_free(const JointRef& q) const override { return sensor_.position_free(q); }
  bool motion_free(const JointRef& from, const JointRef& to) const override {
    return sensor_.motion_free(from, to);
  }
  std::optional<bool> try_motion(const JointRef& from, const JointRef& to,
                                 const StopCondition& stop) const override {
    return sensor_.try_motion(from, to, stop);
  }
  /// Not free of a sensor that knows no curves: the motion rests at its waypoints then.
  std::optional<bool> try_curve(const Trajectory& curve, double from, double to,
                                const StopCondition& stop) const override {
    JointVector most = JointVector::Zero(arm_.size());
    for (const auto& knot : curve.knots())
      if (knot.time >= from - kInstant && knot.time <= to + kInstant)
        most = most.cwiseMax(knot.ddq.cwiseAbs());
    // Accelerations are even between knots: at the ends, where there may be none.
    for (const double time : {from, to}) most = most.cwiseMax(curve.at(time).ddq.cwiseAbs());
    Poller poller(stop, kPolled);
    if (!keeps_to(curve, from, to, most, poller))
      return poller.stopped() ? std::optional<bool>() : false;
    const auto free = sensor_.try_curve(curve, from, to, stop);
    const bool told = !free && stop.poll() != StopCondition::Cause::none;
    return told ? free : free.value_or(false);
  }
  double clearance() const override { return sensor_.clearance(); }
  std::string contact(const JointRef& q) const override { return sensor_.contact(q); }

 private:
  static constexpr double kInstant = 1e-12;
  static constexpr int kPolled = 256;

  /// By what each joint moves at most about the middle of the time; halved until that is enough.
  bool keeps_to(const Trajectory& curve, double from, double to, const JointVector& most,
                Poller& poller) const {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const Trajectory::State state = curve.at(middle);
    Kinematics::Poses poses;
    arm_.place(as_span(state.q), poses);
    const Placement frame = arm_.tip_frame(poses);
    const Placement there = way_.at(way_.share_of(frame, options_));
    const double off = distance(frame.position, there.position);
    const bool any_turn = options_.angle_tolerance >= std::numbers::pi;
    const double turned = any_turn ? 0 : length(turn_between(there.rotation, frame.rotation));
    if (off > options_.tolerance || turned > options_.angle_tolerance || poller.stop_after(1))
      return false;
    double moved = 0, turns = 0;
    for (int j = 0; j < arm_.size(); ++j) {
      const double change = half * (std::abs(state.dq[j]) + half * most[j]);
      moved += levers_[j] * change;
      if (!any_turn && !arm_.slides(j)) turns += change;
    }
    if (off + moved <= options_.tolerance && turned + turns <= options_.angle_tolerance)
      return true;
    if (half < kInstant) return false;
    return keeps_to(curve, from, middle, most, poller) && keeps_to(curve, middle, to, most, poller);
  }

  const Kinematics& arm_;
  const Sensor& sensor_;
  const FrameLine& way_;
  const TipLineOptions& options_;
  JointArray levers_;
};

/// Appends a waypoint.
void add(const Robot& robot, const JointVector& q, TipLine& line) {
  line.joints.conservativeResize(q.size(), line.joints.cols() + 1);
  line.joints.rightCols<1>() = q;
  line.tips.conservativeResize(Eigen::NoChange, line.joints.cols());
  line.tips.rightCols<1>() = tip_position(robot, q);
}

/// Continues joint values along a line: by the longest chords, halved, that keep to it and are
/// free.
struct LineFollower {
  const Robot& robot;
  const Kinematics& arm;
  const Sensor& sensor;
  const FrameLine& way;
  const TipLineOptions& options;

  /// Appends waypoints from the start on. False where they do not reach the end: line.error or
  /// line.status says why.
  bool follow(JointVector here, TipLine& line) const {
    constexpr double kShortest = 1e-5;
    double step = 1;
    while (line.reached < 1) {
      const auto cause = options.stop.poll();
      if (cause != StopCondition::Cause::none) {
        end_run(line, cause, Status::no_path);
        return false;
      }
      const double s = std::min(1.0, line.reached + step);
      JointVector next = here;
      const auto fault = chord_fault(here, s, next);
      if (!fault) continue;  // told to stop
      if (fault->empty()) {
        add(robot, next, line);
        line.reached = s;
        here = next;
        step *= 2;
      } else if ((step *= 0.5) < kShortest) {
        line.error =
            "after " + number_text(std::round(1e4 * line.reached) / 1e4) + " of the line " + *fault;
        return false;
      }
    }
    return true;
  }

 private:
  /// Why no chord leads from `here` to the place `s` of the line, whose joint values are `next`;
  /// empty where one does. Nothing when stopped.
  std::optional<std::string> chord_fault(const JointVector& here, double s,
                                         JointVector& next) const {
    constexpr double kClose = 1e-9;                 // of waypoints to the line
    constexpr double kMostTurn = 1;                 // of a chord
    const double share = options.motion ? 0.5 : 1;  // of the tolerances, left to the chords
    const bool any_turn = options.angle_tolerance >= std::numbers::pi;
    const TipTarget there{way.at(s), kClose, any_turn ? 2 * std::numbers::pi : kClose};
    if (!arm.reach_pose(there, {next.data(), static_cast<std::size_t>(next.size())}))
      return "joint values continued from the start do not reach on: a limit, or a singular "
             "posture";
    const Deviation most = deviation(arm, here, next);
    const bool keeps_to_line =
        most.off + kClose <= share * options.tolerance &&
        (any_turn ||
         (most.turn <= kMostTurn && most.turned + kClose <= share * options.angle_tolerance));
    if (!(largest_change(here, next) <= options.joint_step && keeps_to_line))
      return "the joints would have to go too far at once: a singular posture";
    const auto free = sensor.try_motion(here, next, options.stop);
    if (!free) return std::nullopt;
    if (*free) return "";
    const std::string contact = sensor.contact(next);
    return "something is in the way" + (contact.empty() ? "" : ": " + contact);
  }
};

/// @throws Error(invalid_parameter).
void check(const TipLineOptions& options) {
  constexpr double kLeast = 1e-6;
  for (const double value : {options.tolerance, options.angle_tolerance})
    require_parameter(value >= kLeast, "a tolerance", value, "it must be 0.000001 or more");
  require_parameter(options.joint_step >= 1e-3, "joint_step", options.joint_step,
                    "it must be 0.001 or more");
  check_duration(options.duration);
}

/// By what a caller names it: links of a lasius-arm/1 as messages do.
std::string name_of(const Robot& robot, int link) {
  const std::string& name = robot.links[link].name;
  return name.empty() ? link_name(robot, link) : name;
}

}  // namespace

std::vector<JointVector> inverse_kinematics(const Robot& robot, const Goal& goal,
                                            const JointVector& near, int most, std::uint64_t seed,
                                            const StopCondition& stop) {
  constexpr int kAttempts = 64;
  validate_but_corners(robot);
  require_parameter(most >= 1, "most", most, "it must be 1 or more");
  std::string fault = values_fault(robot, near, "near", Request::kLimitTolerance);
  const Kinematics arm(robot);
  if (fault.empty()) fault = goal_fault(robot, arm, as_span(near), goal);
  if (!fault.empty()) refuse(fault, "give values and a goal within its reach");
  const Request request{.start = near, .goals = {goal}, .stop = stop};
  const std::array<int, 1> only{0};
  std::vector<JointVector> found;
  for (End& end : find_ends(robot, arm, request, only, seed, 0, kAttempts, kAttempts)) {
    if (std::ssize(found) == most) break;
    found.push_back(std::move(end.q));
  }
  return found;
}

TipLine tip_line(const Robot& robot, const Sensor& sensor, const JointVector& start,
                 const Pose& goal, const TipLineOptions& options) {
  validate_but_corners(robot);
  check(options);
  const std::string fault = values_fault(robot, start, "start");
  if (!fault.empty()) refuse(fault, "bring it within them");
  const Kinematics arm(robot);
  TipLine line;
  add(robot, start, line);
  line.error = goal_fault(robot, arm, as_span(start), Goal::pose(goal));
  if (line.error.empty() && !sensor.position_free(start))
    line.error = "the arm touches something at the start: " + sensor.contact(start);
  if (!line.error.empty()) {
    line.status = Status::invalid;
    return line;
  }
  Kinematics::Poses poses;
  arm.place(as_span(start), poses);
  const FrameLine way(arm.tip_frame(poses), from_eigen(goal));
  if (!LineFollower{robot, arm, sensor, way, options}.follow(start, line)) return line;
  line.status = Status::solved;
  line.goal = 0;
  line.length = distance(way.at(0).position, way.at(1).position);
  TrajectoryResult made;
  if (options.motion)
    made = make_trajectory(robot, LineSensor(robot, arm, sensor, way, options), line.joints,
                           {.shortcut = false, .stop = options.stop, .duration = options.duration});
  take_motion(robot, Timing::optimal, std::move(made), line);
  return line;
}

Robot holding(Robot robot, const std::string& name, std::vector<Solid> solids,
              const std::vector<std::string>& may_touch) {
  const int own = static_cast<int>(robot.links.size());
  Link link{.name = name, .body = robot.size(), .parent = -1, .solids = std::move(solids)};
  for (Solid& solid : link.solids)
    solid.pose = to_eigen(from_eigen(robot.tip) * from_eigen(solid.pose));
  for (const std::string& other : may_touch) {
    int at = 0;
    std::string names;
    for (; at < own && name_of(robot, at) != other; ++at)
      names += (at > 0 ? ", " : "") + name_of(robot, at);
    if (at == own)
      refuse("no link of the robot is called \"" + other + "\"", "its links are " + names);
    robot.may_touch.emplace_back(at, own);
  }
  robot.links.push_back(std::move(link));
  validate(robot);
  return robot;
}

}  // namespace lasius::arm
