#include "core/arm/request_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/arm/two_trees.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"

namespace lasius::arm {
namespace {

constexpr int kAttempts = 64;  // of inverse kinematics

Result invalid(Fault fault, const std::string& why) {
  return failed<Result>(Status::invalid, fault, why);
}

/// The box of the lattice: all that the arm can reach, or `side` points about the middle of start
/// and the first target; start and targets within. Nothing where it has too many points.
std::optional<Box> box_of(const Kinematics& arm, Vec3 from, double pitch, int side,
                          std::span<const std::array<int, 3>> targets, double& nodes) {
  const std::array<double, 3> start{from.x, from.y, from.z};
  const Vec3 s = arm.shoulder();
  const std::array<double, 3> shoulder{s.x, s.y, s.z};
  Box box;
  nodes = 1;
  for (int i = 0; i < 3; ++i) {
    if (side > 0) {
      const int middle = targets[0][i] / 2;
      box.low[i] = middle - (side - 1) / 2;
      box.high[i] = box.low[i] + side - 1;
    } else {
      const auto most = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
      box.low[i] = most(std::ceil((shoulder[i] - arm.reach() - start[i]) / pitch));
      box.high[i] = most(std::floor((shoulder[i] + arm.reach() - start[i]) / pitch));
    }
    box.low[i] = std::min(box.low[i], 0);
    box.high[i] = std::max(box.high[i], 0);
    for (const auto& at : targets) {
      box.low[i] = std::min(box.low[i], at[i]);
      box.high[i] = std::max(box.high[i], at[i]);
    }
    nodes *= box.high[i] - box.low[i] + 3;
  }
  if (nodes > static_cast<double>(Lattice::kMostNodes)) return std::nullopt;
  return box;
}

/// The lattice point next to a place; the tip starts at the point 0.
std::array<int, 3> point_near(Vec3 from, Vec3 to, double pitch) {
  const Vec3 way = (1 / pitch) * (to - from);
  if (!(length(way) < 1e6))
    refuse("pitch is " + number_text(pitch) + ", too small for this goal", "take a larger one");
  return rounded(way);
}

}  // namespace

RequestSolver::RequestSolver(const Robot& robot, const Sensor& sensor, const Request& request,
                             const Params& given)
    : robot_(robot), sensor_(sensor), request_(request), parameters_(given) {
  validate_but_corners(robot);
  validate(given);
  check_target_gap(request.target_gap);
  request_.start = within_limits(robot, request.start, "start", notes_);
  for (Goal& goal : request_.goals)
    if (goal.kind == Goal::Kind::joints)
      goal.values = within_limits(robot, goal.values, "goal", notes_);
  // What fits in the last questions must not depend on who comes first.
  parameters_.threads = given.max_questions > 0 ? 1 : thread_count(given.threads);
}

Result RequestSolver::solve(const Search& search) {
  const std::string fault = values_fault(robot_, request_.start, "start");
  if (!fault.empty()) return invalid(Fault::start_outside, fault);
  arm_.emplace(robot_);
  if (parameters_.pitch == 0) parameters_.pitch = arm_->reach() / 20;
  from_ = tip_of(request_.start);
  Result result = reach_goals(search);
  if (result.points[0] == 0 && !goals_.empty()) fill_lattice_fields(result);
  result.notes = notes_;
  result.questions.positions = std::max(result.questions.positions, asked_.positions);
  result.questions.motions = std::max(result.questions.motions, asked_.motions);
  if (result.status == Status::limit || result.status == Status::interrupted) result.error.clear();
  if (result.status != Status::limit)
    result.limit = Limit::none;
  else if (out_of_questions_)
    result.limit = Limit::questions;
  return result;
}

Result RequestSolver::reach_goals(const Search& search) {
  std::string faults = request_.goals.empty() ? "no goal is given" : "";
  for (int g = 0; g < static_cast<int>(request_.goals.size()); ++g) {
    std::string one = goal_fault(robot_, *arm_, as_span(request_.start), request_.goals[g]);
    if (one.empty())
      goals_.push_back(g);
    else
      faults += (faults.empty() ? "" : "; ") + one;
  }
  if (goals_.empty()) return invalid(Fault::goal_outside, faults);
  if (!position_free(request_.start)) {
    const std::string contact = sensor_.contact(request_.start);
    return invalid(Fault::start_blocked, "the arm touches something at the start" +
                                             (contact.empty() ? "" : ": " + contact));
  }
  for (const int g : goals_)
    if (is_at(robot_, *arm_, request_.goals[g], request_.start)) return stay_at_goal(g);
  if (auto done = find_targets()) return *std::move(done);
  if (parameters_.trees == 0) return search_lattice(search);
  return ends_.empty() ? no_ends() : grow_trees();
}

Result RequestSolver::stay_at_goal(int goal) const {
  auto result = already_there<Result>();
  result.joints = request_.start;
  result.tips = Eigen::Vector3d(from_);
  result.goal = goal;
  return result;
}

bool RequestSolver::position_free(const JointVector& q) {
  ++asked_.positions;
  return sensor_.position_free(q);
}
StopCondition::Cause RequestSolver::cause() {
  const int most = parameters_.max_questions;
  if (most == 0 || asked_.positions + asked_.motions < most) return request_.stop.poll();
  out_of_questions_ = true;
  return StopCondition::Cause::deadline;
}

std::optional<Result> RequestSolver::find_targets() {
  std::vector<int> wanted;
  const auto points = targets_at(parameters_.pitch).points;
  for (const int g : goals_) {
    const bool point =
        std::ranges::any_of(points, [&](const Targets::Point& one) { return one.goal == g; });
    if (parameters_.direct || parameters_.trees > 0 || !point) wanted.push_back(g);
  }
  if (wanted.empty()) return std::nullopt;
  const int most = parameters_.trees > 0 ? 24 : 4;
  ends_ = find_ends(robot_, *arm_, request_, wanted, parameters_.seed, 0, kAttempts, most);
  std::vector<End> all = ends_;
  if (auto line = drop_blocked_ends()) return line;
  if (!ends_.empty() || ended()) return std::nullopt;
  // Where all of them touch something, more are looked for before that is said.
  ends_ = find_ends(robot_, *arm_, request_, wanted, parameters_.seed, kAttempts, 3 * kAttempts,
                    3 * most, all);
  all.insert(all.end(), ends_.begin(), ends_.end());
  if (auto line = drop_blocked_ends()) return line;
  if (!ends_.empty() || all.empty() || wanted.size() < goals_.size() || ended() ||
      (parameters_.trees == 0 && is_point(wanted.front()))) {
    return std::nullopt;
  }
  const std::string contact = sensor_.contact(all.front().q);
  return invalid(Fault::goal_blocked,
                 "the arm touches something at the goal, in " +
                     (all.size() == 1 ? "the only posture"
                                      : "each of " + std::to_string(all.size()) + " postures") +
                     " found" + (contact.empty() ? "" : ": " + contact));
}

std::optional<Result> RequestSolver::drop_blocked_ends() {
  std::vector<End> free;
  for (End& end : ends_) {
    if (ended() || !position_free(end.q)) continue;
    if (parameters_.direct && !ended()) {
      ++asked_.motions;
      if (sensor_.try_motion(request_.start, end.q, request_.stop).value_or(false))
        return straight_line_result(end);
    }
    free.push_back(std::move(end));
  }
  ends_ = std::move(free);
  return std::nullopt;
}

bool RequestSolver::every_posture_blocked() {
  const std::vector<End> ends =
      find_ends(robot_, *arm_, request_, goals_, parameters_.seed, 0, kAttempts, kAttempts);
  const auto free = [&](const End& end) { return ended() || position_free(end.q); };
  return std::ranges::none_of(ends, free) && !ended();
}

Vec3 RequestSolver::tip_of(const JointVector& q) const {
  Kinematics::Poses poses;
  arm_->place(as_span(q), poses);
  return arm_->tip(poses);
}

double RequestSolver::line_length(const JointVector& a, const JointVector& b) const {
  if (parameters_.objective == Objective::joint) return joint_travel(a, b);
  if (parameters_.objective == Objective::duration) {
    double longest = 0;
    for (int j = 0; j < robot_.size(); ++j)
      longest = std::max(longest, std::abs(b[j] - a[j]) / robot_.joints[j].velocity);
    return longest;
  }
  const auto at = point_near(tip_of(a), tip_of(b), parameters_.pitch);
  const int moves = std::abs(at[0]) + std::abs(at[1]) + std::abs(at[2]);
  return parameters_.pitch * std::max({1.0, static_cast<double>(moves),
                                       std::ceil(largest_change(a, b) / parameters_.joint_step)});
}

Result RequestSolver::straight_line_result(const End& end) const {
  Result result;
  result.status = Status::solved;
  result.goal = end.goal;
  result.direct = true;
  result.joints.resize(request_.start.size(), 2);
  result.joints << request_.start, end.q;
  result.tips.resize(3, 2);
  result.tips << Eigen::Vector3d(from_), Eigen::Vector3d(end.tip);
  result.length = line_length(request_.start, end.q);
  return result;
}

Result RequestSolver::grow_trees() {
  const auto may_ask = [&] {
    if (ended()) return false;
    ++asked_.motions;
    return true;
  };
  const TreesWay way = grow_two_trees(robot_, sensor_, request_, ends_, parameters_.trees,
                                      parameters_.seed, may_ask);
  Result result;
  const bool met = !way.waypoints.empty();
  end_run(result, met ? StopCondition::Cause::none : cause(),
          met ? Status::solved : Status::no_path);
  if (!met) {
    result.error = "two trees of motions did not meet, after " + std::to_string(parameters_.trees) +
                   " joint values; try more (trees), or another seed";
    return result;
  }
  result.goal = way.goal;
  result.trees = true;
  const std::ptrdiff_t count = std::ssize(way.waypoints);
  result.joints.resize(robot_.size(), count);
  result.tips.resize(3, count);
  result.length = 0;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    result.joints.col(i) = way.waypoints[i];
    result.tips.col(i) = Eigen::Vector3d(tip_of(way.waypoints[i]));
    if (i > 0) result.length += line_length(way.waypoints[i - 1], way.waypoints[i]);
  }
  return result;
}

Targets RequestSolver::targets_at(double pitch) const {
  Targets targets{{}, ends_};
  for (const int g : goals_) {
    if (!is_point(g)) continue;
    const Vec3 position = request_.goals[g].target.translation().eval();
    const auto at = point_near(from_, position, pitch);
    const bool taken =
        std::ranges::any_of(targets.points, [&](const auto& other) { return other.at == at; });
    if (!taken && at != std::array<int, 3>{}) targets.points.push_back({at, position, g});
  }
  return targets;
}

Result RequestSolver::no_ends() {
  Result result;
  end_run(result, cause(), Status::no_path);
  result.error = "no joint values were found that reach the goal, in " +
                 std::to_string(4 * kAttempts) +
                 " attempts from random ones; try larger tolerances, or another orientation";
  return result;
}

Result RequestSolver::search_lattice(const Search& search) {
  const double pitch = parameters_.pitch;
  Targets targets = targets_at(pitch);
  std::vector<std::array<int, 3>> at;
  for (const auto& point : targets.points) at.push_back(point.at);
  for (const End& end : targets.ends) at.push_back(point_near(from_, end.tip, pitch));
  if (at.empty()) return no_ends();
  double nodes = 0;
  const auto box = box_of(*arm_, from_, pitch, parameters_.side, at, nodes);
  if (!box)
    refuse("pitch is " + number_text(pitch) + ", which makes a lattice of " + number_text(nodes) +
               " points",
           "take a larger pitch or a smaller side: at most " + std::to_string(Lattice::kMostNodes) +
               " fit");
  Lattice lattice(robot_, *arm_, sensor_, request_.start, pitch, *box, std::move(targets),
                  parameters_, request_.stop, asked_);
  Result result;
  if (lattice.has_target()) {
    result = search(lattice, parameters_);
  } else {  // or it was not looked for: it was told to stop
    end_run(result, cause(), Status::no_path);
    result.error = lattice.not_found() +
                   ": joint values continued from the start do not reach the goal; " + kTryElse;
  }
  asked_ = lattice.questions();
  out_of_questions_ |= lattice.out_of_questions();
  if (result.fault == Fault::goal_blocked && !every_posture_blocked()) {
    result.fault = Fault::none;
    end_run(result, cause(), Status::no_path);
    result.error = lattice.not_found() + ", the posture tried at the goal touches something; " +
                   "try the algorithm postures";
  }
  result.questions = asked_;
  result.pitch = pitch;
  for (int i = 0; i < 3; ++i) result.points[i] = box->high[i] - box->low[i] + 1;
  return result;
}

void RequestSolver::fill_lattice_fields(Result& result) const {
  const Goal& goal = request_.goals[goals_.front()];
  const bool joints = goal.kind == Goal::Kind::joints;
  const Vec3 to = joints ? from_ : Vec3(goal.target.translation().eval());
  const std::array<std::array<int, 3>, 1> at{{point_near(from_, to, parameters_.pitch)}};
  double nodes = 0;
  result.pitch = parameters_.pitch;
  const auto box = box_of(*arm_, from_, result.pitch, parameters_.side, at, nodes);
  for (int i = 0; box && i < 3; ++i) result.points[i] = box->high[i] - box->low[i] + 1;
}

}  // namespace lasius::arm
