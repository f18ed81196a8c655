#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "core/arm/arm_colony.h"
#include "core/arm/check_clearance.h"
#include "core/arm/lattice_way.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"
#include "lasius/arm_plan.h"
#include "lasius/error.h"

namespace lasius::arm {
namespace {

Result invalid(Fault fault, const std::string& why) {
  return failed<Result>(Status::invalid, fault, why);
}

std::string joint_name(const Robot& robot, int j) {
  const std::string& name = robot.joints[j].name;
  return "joint " + std::to_string(j + 1) + (name.empty() ? "" : " (" + name + ")");
}

std::string text(Vec3 p) {
  return number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z);
}

std::string metres(double length) {
  std::array<char, 32> digits;
  std::snprintf(digits.data(), digits.size(), "%.4g", length);
  return digits.data();
}

/// Why the arm cannot stand at `start`; empty where it can, as far as kinematics tells.
std::string start_fault(const Robot& robot, const JointVector& start) {
  if (start.size() != robot.size()) {
    return "start has " + std::to_string(start.size()) + " joint values, the robot needs " +
           std::to_string(robot.joints.size());
  }
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (start[j] >= joint.low && start[j] <= joint.high) continue;
    return "start: " + joint_name(robot, j) + " is " + number_text(start[j]) + ", its limits are " +
           number_text(joint.low) + " .. " + number_text(joint.high);
  }
  return {};
}

/// The box of the lattice: all that the arm can reach, or `side` points about the middle of start
/// and goal; start and goal within.
struct Box {
  std::array<int, 3> low, high;
};
Box box_of(const Kinematics& arm, Vec3 from, double pitch, int side,
           const std::array<int, 3>& goal) {
  const std::array<double, 3> start{from.x, from.y, from.z};
  const Vec3 s = arm.shoulder();
  const std::array<double, 3> shoulder{s.x, s.y, s.z};
  Box box;
  double points = 1;
  for (int i = 0; i < 3; ++i) {
    if (side > 0) {
      const int middle = goal[i] / 2;
      box.low[i] = middle - (side - 1) / 2;
      box.high[i] = box.low[i] + side - 1;
    } else {
      const auto most = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
      box.low[i] = most(std::ceil((shoulder[i] - arm.reach() - start[i]) / pitch));
      box.high[i] = most(std::floor((shoulder[i] + arm.reach() - start[i]) / pitch));
    }
    box.low[i] = std::min({box.low[i], 0, goal[i]});
    box.high[i] = std::max({box.high[i], 0, goal[i]});
    points *= box.high[i] - box.low[i] + 3;
  }
  if (points > static_cast<double>(Lattice::kMostNodes)) {
    throw Error(ErrorCode::invalid_parameter,
                "pitch is " + number_text(pitch) + ", which makes a lattice of " +
                    number_text(points) + " points",
                "take a larger pitch or a smaller side: at most " +
                    std::to_string(Lattice::kMostNodes) + " points fit");
  }
  return box;
}

/// Why the tip cannot get to `goal`, wherever it starts; empty where the arm is long enough.
std::string goal_fault(const Kinematics& arm, Vec3 goal) {
  if (distance(goal, arm.shoulder()) <= arm.reach() + Kinematics::kTolerance) return {};
  return "goal " + text(goal) + " is outside: it is " + metres(distance(goal, arm.shoulder())) +
         " m from the arm's first joint, the arm reaches " + metres(arm.reach()) + " m";
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

/// Why the tip does not get from `start` to `goal`, which the arm is long enough for.
std::string way_fault(const Kinematics& arm, std::span<const double> start, Vec3 goal) {
  const std::string name = "goal " + text(goal);
  Kinematics::Poses poses;
  arm.place(start, poses);
  if (const auto normal = plane_of(arm, poses)) {
    const double off = std::abs(dot(*normal, goal - arm.tip(poses)));
    if (off > Kinematics::kTolerance) {
      return name + " is out of reach: the joints move the tip in one plane, the goal is " +
             metres(off) + " m off it";
    }
  }
  std::vector<double> q(start.begin(), start.end());
  const bool straight = arm.reach_for(goal, start, q);
  arm.place(q, poses);
  std::string fault =
      straight
          ? name + " is out of reach in steps of the lattice; take a smaller pitch"
          : name + " is out of reach: within the joint limits the tip gets from the start to " +
                metres(distance(goal, arm.tip(poses))) + " m from it";
  if (arm.size() < 3) {
    fault += "; " + std::to_string(arm.size()) +
             (arm.size() == 1 ? " joint moves a tip along a curve only"
                              : " joints move a tip on a surface only");
  }
  return fault;
}

/// The lattice point next to the goal; the tip starts at the point 0.
std::array<int, 3> goal_point(Vec3 from, Vec3 goal, double pitch) {
  const Vec3 way = (1 / pitch) * (goal - from);
  if (!(length(way) < 1e6)) {
    throw Error(ErrorCode::invalid_parameter,
                "pitch is " + number_text(pitch) + ", too small for this goal",
                "take a larger one");
  }
  return {static_cast<int>(std::lround(way.x)), static_cast<int>(std::lround(way.y)),
          static_cast<int>(std::lround(way.z))};
}

/// The answer where the goal is the start.
Result stay(const JointVector& start, Vec3 tip) {
  auto result = already_there<Result>();
  result.joints = start;
  result.tips = Eigen::Vector3d(tip);
  return result;
}

/// Checks a question, lays out its lattice, and has it answered by `search(lattice, parameters)`.
template <class Search>
Result answer(const Robot& robot, const Sensor& sensor, const Request& request, const Params& given,
              const Search& search) {
  validate(robot);
  validate(given);
  check_target_gap(request.target_gap);
  Params parameters = given;
  parameters.threads = thread_count(parameters.threads);
  std::string fault = start_fault(robot, request.start);
  if (!fault.empty()) return invalid(Fault::start_outside, fault);
  const Kinematics arm(robot);
  const auto start = as_span(request.start);
  const Vec3 to = request.goal;
  fault = goal_fault(arm, to);
  if (!fault.empty()) return invalid(Fault::goal_outside, fault);

  if (parameters.pitch == 0) parameters.pitch = arm.reach() / 20;
  Kinematics::Poses poses;
  arm.place(start, poses);
  const Vec3 from = arm.tip(poses);
  const auto goal = goal_point(from, to, parameters.pitch);
  const bool at_start = goal == std::array<int, 3>{0, 0, 0};
  if (at_start && distance(from, to) > Kinematics::kTolerance) {
    return invalid(
        Fault::goal_outside,
        "goal " + text(to) + " is less than half a pitch from the start; take a smaller pitch");
  }
  const Box box = box_of(arm, from, parameters.pitch, parameters.side, goal);
  const Lattice lattice(arm, sensor, start, parameters.pitch, box.low, box.high, goal, to,
                        parameters);
  const auto in_lattice = [&] {
    if (!lattice.position_free(lattice.start())) {
      const std::string contact = sensor.contact(request.start);
      return invalid(Fault::start_blocked, "the arm touches something at the start" +
                                               (contact.empty() ? "" : ": " + contact));
    }
    if (at_start) return stay(request.start, from);
    if (lattice.configuration(lattice.goal()) == nullptr) {
      return invalid(Fault::goal_outside, way_fault(arm, start, to));
    }
    return search(lattice, parameters);
  };
  Result result = in_lattice();
  result.pitch = parameters.pitch;
  for (int i = 0; i < 3; ++i) result.points[i] = box.high[i] - box.low[i] + 1;
  result.questions = lattice.questions();
  return result;
}

}  // namespace

Result plan(const Robot& robot, const Sensor& sensor, const Request& request,
            const Params& parameters, const Observer& observer) {
  const auto search = [&](const Lattice& lattice, const Params& p) {
    return run_arm_colony(lattice, request, p, observer);
  };
  if (request.motion) check_clearance(sensor);
  Result result = answer(robot, sensor, request, parameters, search);
  if (!request.motion || result.joints.cols() == 0) return result;
  StopCondition stop = request.stop;
  if (result.status == Status::interrupted) {  // perhaps by the observer, whom no token knows
    std::stop_source ended;
    ended.request_stop();
    stop.token = ended.get_token();
  }
  TrajectoryResult made = make_trajectory(robot, sensor, result.joints,
                                          {.shortcut = parameters.shortcut, .stop = stop});
  if (result.status == Status::solved) result.status = made.status;
  result.trajectory = std::move(made.trajectory);
  result.waypoints = made.waypoints;
  result.stops = made.stops;
  result.questions.trajectory = made.questions;
  return result;
}

Result shortest_lattice_way(const Robot& robot, const Sensor& sensor, const Request& request,
                            const Params& parameters) {
  const auto search = [&](const Lattice& lattice, const Params&) {
    const KnownWay way = shortest_known_way(lattice, Unknown::is_asked, request.stop);
    Result result;
    result.status = status_after(way.cause, way.moves ? Status::solved : Status::unreachable);
    if (!way.moves) return result;
    result.length = static_cast<double>(*way.moves) * lattice.pitch();
    result.lower_bound = result.length;
    result.optimal = true;
    return result;
  };
  return answer(robot, sensor, request, parameters, search);
}

Result straight_lattice_way(const Robot& robot, const Sensor& sensor, const Request& request,
                            const Params& parameters) {
  const auto search = [&](const Lattice& lattice, const Params&) {
    Result result;
    Node at = lattice.start();
    LatticePoller poller(lattice, request.stop, Poller::kSteps);
    const auto moves = straight_moves(lattice);
    for (const int move : moves) {
      const bool open = lattice.open(at, move);
      if (poller.stop_after(1)) {
        result.status = status_after(poller.cause(), result.status);
        return result;
      }
      if (!open) return result;
      at = lattice.to(at, move);
    }
    result.status = Status::solved;
    result.length = static_cast<double>(moves.size()) * lattice.pitch();
    return result;
  };
  return answer(robot, sensor, request, parameters, search);
}

}  // namespace lasius::arm
