#include "lasius/arm/plan.h"

#include "core/arm/arm_colony.h"
#include "core/arm/lattice_way.h"
#include "core/arm/plan_check.h"
#include "core/arm/request_solver.h"
#include "core/base/poller.h"
#include "core/loop/run_status.h"

namespace lasius::arm {
namespace {

/// The answer of a search that knows the way, without joints.
Result answer_of(const KnownWay& way, const Lattice& lattice) {
  Result result;
  end_run(result, way.cause, way.cost ? Status::solved : Status::no_path);
  if (!way.cost) return result;
  result.length = *way.cost * lattice.unit();
  result.lower_bound = result.length;
  result.optimal = true;
  return result;
}

/// The lattice, and nothing but it.
Params lattice_alone(Params parameters) {
  parameters.direct = false;
  parameters.trees = 0;
  return parameters;
}

}  // namespace

Goal::Goal(const Eigen::Vector3d& position) { target.translation() = position; }

Goal Goal::pose(const Pose& pose, double position_tolerance, double angle_tolerance) {
  Goal goal(pose.translation().eval());
  goal.kind = Kind::pose;
  goal.target = pose;
  goal.position_tolerance = position_tolerance;
  goal.angle_tolerance = angle_tolerance;
  return goal;
}

Goal Goal::joints(const JointRef& q) {
  Goal goal(Eigen::Vector3d::Zero().eval());
  goal.kind = Kind::joints;
  goal.values = q;
  return goal;
}

void take_motion(const Robot& robot, Timing timing, TrajectoryResult made, Result& result) {
  if (result.status == Status::solved) {
    result.status = made.status;
    result.limit = made.limit;
  }
  result.trajectory = std::move(made.trajectory);
  result.waypoints = made.waypoints;
  result.stops = made.stops;
  result.questions.trajectory = made.questions;
  const Kinematics arm(robot);
  Kinematics::Poses poses;
  JointVector before;
  Vec3 tip_before;
  const auto go_on = [&](const JointVector& q) {
    arm.place(as_span(q), poses);
    const Vec3 tip = arm.tip(poses);
    if (before.size() > 0) {
      result.joint_travel += joint_travel(before, q);
      result.tip_travel += distance(tip, tip_before);
    }
    before = q;
    tip_before = tip;
  };
  result.duration = result.trajectory.duration();
  if (result.trajectory.empty()) {
    for (const auto q : result.joints.colwise()) go_on(q);
    return;
  }
  constexpr int kPieces = 16, kInAll = 128;  // between two knots of a spline; of other motions
  const auto& knots = result.trajectory.knots();
  go_on(knots.front().q);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double h = knots[i + 1].time - knots[i].time;
    if (timing == Timing::optimal && !(h > 0)) continue;
    const int pieces =
        timing == Timing::splines ? kPieces : 1 + static_cast<int>(kInAll * h / result.duration);
    for (int p = 1; p <= pieces; ++p) {
      const double share = static_cast<double>(p) / pieces;
      go_on(result.trajectory.at((1 - share) * knots[i].time + share * knots[i + 1].time).q);
    }
  }
}

Result plan(const Robot& robot, const Sensor& sensor, const Request& request,
            const Params& parameters, const Observer& observer) {
  if (request.motion) {
    check_clearance(sensor);
    check_duration(request.duration);
  }
  RequestSolver solver(robot, sensor, request, parameters);
  Result result = solver.solve([&](Lattice& lattice, const Params& p) {
    return run_arm_colony(lattice, solver.request(), p, observer);
  });
  if (result.joints.cols() == 0) return result;
  TrajectoryResult made;
  if (request.motion) {
    StopCondition stop = request.stop;
    if (result.status == Status::interrupted) {  // perhaps by the observer, whom no token knows
      std::stop_source ended;
      ended.request_stop();
      stop.token = ended.get_token();
    }
    TrajectoryOptions options{.shortcut = parameters.shortcut,
                              .shortcuts = parameters.shortcuts,
                              .seed = parameters.seed,
                              .quick = parameters.objective == Objective::duration,
                              .timing = parameters.timing,
                              .stop = stop,
                              .duration = request.duration};
    const Questions& asked = result.questions;
    if (parameters.max_questions > 0)
      options.max_questions = parameters.max_questions - asked.positions - asked.motions;
    made = make_trajectory(robot, sensor, result.joints, options);
  }
  take_motion(robot, parameters.timing, std::move(made), result);
  return result;
}

Result shortest_lattice_way(const Robot& robot, const Sensor& sensor, const Request& request,
                            const Params& parameters) {
  return RequestSolver(robot, sensor, request, lattice_alone(parameters))
      .solve([&](Lattice& lattice, const Params&) {
        return answer_of(shortest_known_way(lattice, Unknown::is_asked, request.stop), lattice);
      });
}

Result straight_lattice_way(const Robot& robot, const Sensor& sensor, const Request& request,
                            const Params& parameters) {
  const auto search = [&](Lattice& lattice, const Params&) {
    Result result;
    Node at = lattice.start();
    LatticePoller poller(lattice, request.stop, Poller::kSteps);
    const auto moves = straight_moves(lattice);
    for (const int move : moves) {
      const bool open = lattice.open(at, move);
      if (poller.stop_after(1)) {
        end_run(result, poller.cause(), result.status);
        return result;
      }
      if (!open) return result;
      at = lattice.to(at, move);
    }
    result.status = Status::solved;
    result.length = static_cast<double>(moves.size()) * lattice.pitch();
    return result;
  };
  return RequestSolver(robot, sensor, request, lattice_alone(parameters)).solve(search);
}

}  // namespace lasius::arm
