#include <algorithm>
#include <cmath>

#include "tools/arm/arm_answer.h"
#include "tools/arm/arm_inverse.h"
#include "tools/arm/arm_json.h"
#include "tools/arm/arm_kind.h"
#include "tools/arm/arm_picture.h"
#include "tools/arm/arm_report.h"
#include "tools/arm/arm_samples.h"
#include "tools/arm/arm_tip.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/signals.h"
#include "tools/console/values.h"
#include "tools/record/problem.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// A file that was just read.
ReadFile hashed(const std::string& file) { return {file, file_hash(file)}; }

std::vector<ReadFile> hashed(const std::vector<std::string>& files) {
  std::vector<ReadFile> list;
  for (const std::string& file : files) list.push_back(hashed(file));
  return list;
}

/// The files that a scene names, each once.
std::vector<std::string> files_of(const arm::Scene& scene) {
  std::vector<std::string> files;
  for (const arm::Obstacle& obstacle : scene.obstacles)
    if (!obstacle.file.empty() && std::ranges::find(files, obstacle.file) == files.end())
      files.push_back(obstacle.file);
  return files;
}

/// The joint values of a state. @throws UsageError, with the nearest name.
const arm::JointVector& state_of(const arm::Robot& robot, const std::string& option,
                                 const std::string& name) {
  if (robot.states.empty())
    throw UsageError(option + " " + name +
                     ": no states are known; give joint values, or --srdf with the robot's states");
  std::vector<std::string_view> names;
  for (const auto& [known, values] : robot.states) names.push_back(known);
  return robot.states.at(std::string(names[choice_value(option, name, names)]));
}

arm::Pose pose_of(const std::vector<double>& v) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  arm::Pose pose = arm::Pose::Identity();
  pose.translation() = Vector3d(v[0], v[1], v[2]);
  pose.linear() = (AngleAxisd(v[5], Vector3d::UnitZ()) * AngleAxisd(v[4], Vector3d::UnitY()) *
                   AngleAxisd(v[3], Vector3d::UnitX()))
                      .toRotationMatrix()
                      .unaryExpr([](double entry) {  // rounded: another C library gives the same
                        return std::round(entry * 0x1p40) * 0x1p-40;
                      });
  return pose;
}

std::string recheck_text(const arm::Recheck& recheck) {
  return "recheck: " + counted(recheck.samples, "sample") + ", " +
         counted(recheck.contacts, "contact") + ", " + counted(recheck.limits, "broken limit") +
         ", nearest " + to_text(recheck.nearest) + " m; between them " +
         (recheck.unproven == 0
              ? "nothing is touched either"
              : counted(recheck.unproven, "piece") + " could not be shown to be free");
}

/// What of the motion is not as one may expect, and what it takes for granted.
std::vector<std::string> remarks_of(const ArmCommand& command, const ArmAnswer& found) {
  const arm::Result& motion = found.plan;
  std::vector<std::string> remarks;
  for (const auto* notes : {&found.robot.notes, &found.robot.warnings, &found.scene.warnings,
                            &found.held.warnings, &motion.notes})
    remarks.insert(remarks.end(), notes->begin(), notes->end());
  const auto say = [&](std::string text) { remarks.push_back(std::move(text)); };
  const std::string takes = "the motion takes ";
  if (motion.stops)
    say(std::string("the motion rests at each waypoint: ") +
        (motion.status == Status::solved    ? "no faster one between them was found free"
         : motion.limit == Limit::questions ? "no questions were left to look for a faster one"
                                            : "there was no time to look for a faster one"));
  if (command.duration > 0 && motion.duration > command.duration)
    say(takes + to_text(motion.duration) + " s, as the joints' limits ask, not " +
        to_text(command.duration) + " s");
  if (sample_rate(motion.trajectory, command.rate) < command.rate)
    say(takes + whole_text(motion.trajectory.duration()) + " s: it is sampled " +
        whole_text(kMostSamples) + " times in all, not " + whole_text(command.rate) +
        " times a second");
  if (command.recheck > 0 && !found.recheck && !motion.trajectory.empty())
    say("the recheck was interrupted");
  if (found.recheck && !command.json) say(recheck_text(*found.recheck));
  if (command.json) return remarks;
  const bool moved =
      !motion.trajectory.empty() && motion.trajectory.knots().back().q != found.start;
  if (moved)
    say("the motion made of the way that was found: " + decimal_text(motion.tip_travel, 3) +
        " m of the tip, " + decimal_text(motion.joint_travel, 3) + " rad of the joints, " +
        decimal_text(motion.duration, 3) + " s");
  if (!found.nearest.empty()) say("at the start: " + nearest_text(found.nearest.front()));
  if (moved && found.nearest.size() > 1) say("at the end: " + nearest_text(found.nearest.back()));
  for (std::size_t i = 0; i < found.inverse.size(); ++i)
    say("joint values " + std::to_string(i + 1) + ": " +
        (found.inverse[i].free ? "free, " : "not free, ") + nearest_text(found.inverse[i].nearest));
  return remarks;
}

/// `lasius arm`.
class ArmProblem : public ProblemOf<ArmCommand> {
 public:
  using ProblemOf::ProblemOf;

  std::optional<std::int64_t> read(const std::stop_token&) override {
    const EndAtOnce unpolled;
    found_.parameters = make_params<arm::Params>(command_, arm_kind());
    read_robot();
    found_.scene = arm::read_scene(command_.scene);
    found_.scene_file = hashed(command_.scene);
    found_.scene_files = hashed(files_of(found_.scene));
    found_.clearance = command_.clearance > 0 ? command_.clearance : arm::SceneSensor::kClearance;
    read_held();
    found_.start = joint_values("--start", command_.start, command_.start_state);
    if (command_.goals.empty())  // --nearest alone
      command_.goals.push_back(
          {ArmGoal::Kind::joints, {found_.start.begin(), found_.start.end()}, {}});
    for (const ArmGoal& goal : command_.goals) found_.goals.push_back(goal_of(goal));
    for (const auto* files : {&found_.scene_files, &found_.robot_files, &found_.held_files})
      for (const auto& [file, hash] : *files) command_.inputs.push_back(file);
    if (command_.messages.verbose) note_inputs();
    return most_iterations(algorithm(), found_.parameters.iterations);
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    arm::Observer observer;
    if (watch)
      observer = [&](const arm::ArmProgress& progress) {
        const auto asked = progress.questions;
        watch(progress.iteration + 1,
              best_text(progress.best_length, unit_of(found_.parameters.objective)) + ", " +
                  counted(asked.positions + asked.motions, "question"));
      };
    const arm::SceneSensor sensor(found_.robot, found_.scene, found_.clearance);
    const auto begin = Clock::now();
    const arm::Request request{.start = found_.start,
                               .goals = found_.goals,
                               .stop = stop,
                               .target_gap = command_.target_gap,
                               .duration = command_.duration};
    arm::Result& plan = found_.plan;
    if (command_.inverse > 0)
      find_inverse(command_, sensor, stop, found_);
    else if (command_.straight)
      plan_straight(command_, sensor, stop, found_);
    else
      plan = arm::plan(found_.robot, sensor, request, found_.parameters, observer);
    found_.elapsed_ms = ms_since(begin);
    if (command_.nearest) found_.nearest.push_back(sensor.nearest(found_.start));
    if (command_.nearest && !plan.trajectory.empty())
      found_.nearest.push_back(sensor.nearest(plan.trajectory.knots().back().q));
    if (command_.recheck <= 0 || plan.trajectory.empty()) return;
    const auto recheck = arm::recheck(found_.robot, found_.scene, plan.trajectory, command_.recheck,
                                      {.token = stop.token});
    if (recheck.samples == command_.recheck) found_.recheck = recheck;
  }

  /// Its goal is where the tip goes: at the goal that was reached, or else the first.
  Record record() const override {
    const auto goal = static_cast<std::size_t>(std::max(0, found_.plan.goal));
    Record record{
        .options = command_,
        .algorithm = algorithm(),
        .format = kArmFormat,
        .most_iterations = most_iterations(algorithm(), found_.parameters.iterations),
        .inputs = {{"robot", robot_json(command_, found_)},
                   {"scene", scene_json(found_.scene_file, found_.scene, found_.scene_files)}},
        .start = joint_values_json(found_.start),
        .goal = vector_json(tip_of(found_.robot, found_.goals[goal])),
        .parameters = parameters_of(),
        .result = found_.plan,
        .elapsed_ms = found_.elapsed_ms,
        .unit = unit_of(found_.parameters.objective),
        .axes = 3,
        .remarks = remarks_of(command_, found_)};
    if (!command_.held.empty()) {
      record.inputs["held"] = scene_json(found_.held_file, found_.held, found_.held_files);
      record.inputs["held"]["may_touch"] = command_.held_touches;
    }
    if (command_.inverse > 0) {
      record.unit = unit_of(arm::Objective::joint);
      record.axes = static_cast<std::size_t>(found_.robot.size());
      for (const Reaching& reaching : found_.inverse)
        record.path.insert(record.path.end(), reaching.q.begin(), reaching.q.end());
    }
    for (const Eigen::Vector3d tip : found_.plan.tips.colwise())  // of each lattice point
      record.path.insert(record.path.end(), tip.begin(), tip.end());
    if (!wants_json(command_)) return record;  // its samples are many
    record.answer =
        answer_json(record, path_json(), {{"questions", questions_json(found_.plan)}}, findings());
    return record;
  }
  Forms show(const Record& run) const override {
    const arm::Trajectory& motion = found_.plan.trajectory;
    return {
        .csv = [&](auto& out) { write_csv(out, found_.robot, motion, command_.rate); },
        .picture = [&](auto& file) { write_arm_picture(file, command_, found_); },
        .yaml = [&](auto& out) { write_ros_trajectory(out, found_.robot, motion, command_.rate); },
        .page = [&](auto& out) { write_arm_report(out, run, command_, found_); }};
  }

 private:
  const Algorithm& algorithm() const { return arm::find_algorithm(found_.parameters.algorithm()); }
  Json parameters_of() const {
    Json json = parameters_json(algorithm(), command_);
    json["clearance"] = number(found_.clearance);
    add_limits(json, command_);
    json["rate"] = number(command_.rate);
    json["duration"] = command_.duration > 0 ? number(command_.duration) : Json(nullptr);
    json["use_visual"] = command_.visual;
    json["bodiless"] = command_.bodiless;
    json["allow_contact"] = command_.contacts;
    json["set_joint"] = Json::object();
    for (const auto& [name, value] : command_.joint_values) json["set_joint"][name] = number(value);
    return json;
  }
  Json path_json() const {
    Json json = Json::object();
    const arm::Result& plan = found_.plan;
    json["path"] = nullptr;
    json["joints"] = nullptr;
    for (const Eigen::Vector3d tip : plan.tips.colwise()) json["path"].push_back(vector_json(tip));
    for (const auto q : plan.joints.colwise()) json["joints"].push_back(joint_values_json(q));
    json["start_state"] = text_or_null(command_.start_state);
    json["goals"] = goals_json(command_, found_);
    const bool found = plan.joints.cols() > 0;
    json["goal_reached"] = plan.goal >= 0 ? Json(plan.goal) : Json(nullptr);
    json["direct"] = plan.direct;
    if (plan.trees) json["trees"] = true;  // records from before there were any replay
    json["tip_travel"] = found ? number(plan.tip_travel) : Json(nullptr);
    json["joint_travel"] = found ? number(plan.joint_travel) : Json(nullptr);
    json["duration"] = plan.trajectory.empty() ? Json(nullptr) : number(plan.duration);
    json["notes"] = plan.notes;
    add_tip_json(command_, found_, json);
    json["lattice"] = {{"pitch", number(plan.pitch)},
                       {"points", plan.points},
                       {"postures", plan.asked.empty() ? 0 : 1}};
    return json;
  }
  Json findings() const {
    Json json = {{"trajectory", trajectory_json(found_, command_.rate)}};
    if (const auto& recheck = found_.recheck)
      json["recheck"] = {
          {"samples", recheck->samples},   {"contacts", recheck->contacts},
          {"limits", recheck->limits},     {"nearest", number(recheck->nearest)},
          {"unproven", recheck->unproven}, {"tip_error", number(recheck->tip_error)}};
    return json;
  }
  void read_robot() {
    found_.robot = arm::read_robot(command_.robot, {.base = command_.base_link,
                                                    .tip = command_.tip_link,
                                                    .set_joints = command_.joint_values,
                                                    .srdf = command_.srdf,
                                                    .joint_limits = command_.joint_limits,
                                                    .allow_contact = command_.contacts,
                                                    .packages = command_.packages,
                                                    .use_visual = command_.visual,
                                                    .bodiless = command_.bodiless});
    found_.robot_file = hashed(command_.robot);
    std::vector<std::string> files = found_.robot.files;
    for (const auto* file : {&command_.srdf, &command_.joint_limits})
      if (!file->empty() && std::ranges::find(files, *file) == files.end()) files.push_back(*file);
    found_.robot_files = hashed(files);
  }
  void read_held() {
    if (command_.held.empty()) return;
    found_.held = arm::read_scene(command_.held);
    found_.held_file = hashed(command_.held);
    found_.held_files = hashed(files_of(found_.held));
    const auto& solids = found_.held.obstacles;
    found_.robot = arm::holding(found_.robot, found_.held.name.empty() ? "held" : found_.held.name,
                                {solids.begin(), solids.end()}, command_.held_touches);
  }
  void note_inputs() {
    const auto joints = joint_names(found_.robot);
    const auto links = link_names(found_.robot);
    const auto say = [&](std::string text) { command_.notes.push_back(std::move(text)); };
    say(command_.robot + ": " + counted(found_.robot.size(), "joint"));
    for (std::size_t i = 0; i < links.size(); ++i) {
      const arm::Link& link = found_.robot.links[i];
      std::string text = "body " + links[i] + ", " +
                         (link.body == 0 ? "stands still" : "moves with " + joints[link.body - 1]);
      for (const arm::Solid& solid : link.solids)
        text +=
            std::string(&solid == link.solids.data() ? ": " : ", ").append(to_string(solid.shape));
      say(std::move(text));
    }
    for (const arm::LinkPair& pair : arm::link_pairs(found_.robot))
      say("pair " + links[pair.first] + ", " + links[pair.second] + ": " +
          (pair.check == arm::LinkPair::Check::yes ? "" : "not checked, ") +
          std::string(to_string(pair.check)));
    say(command_.scene + ": " + counted(found_.scene.obstacles.size(), "obstacle"));
    say(algorithm_text(command_, algorithm(), true));
  }
  /// Those of a state, or as given. @throws UsageError
  arm::JointVector joint_values(const std::string& option, const std::vector<double>& values,
                                const std::string& state) const {
    if (!state.empty()) return state_of(found_.robot, option, state);
    const auto count = static_cast<std::int64_t>(values.size());
    if (count != found_.robot.size())
      throw UsageError(option + " gives " + counted(count, "joint value") + ", " + command_.robot +
                       " has " + counted(found_.robot.size(), "joint"));
    return joint_vector(values);
  }
  arm::Goal goal_of(const ArmGoal& goal) const {
    switch (goal.kind) {
      case ArmGoal::Kind::position:
        break;
      case ArmGoal::Kind::pose:
        return arm::Goal::pose(pose_of(goal.values), command_.position_tolerance,
                               command_.angle_tolerance);
      case ArmGoal::Kind::joints:
        return arm::Goal::joints(joint_values(goal.state.empty() ? "--goal-joints" : "--goal-state",
                                              goal.values, goal.state));
    }
    return arm::Goal::position({goal.values[0], goal.values[1], goal.values[2]});
  }

  ArmAnswer found_;
};

}  // namespace

const ProblemKind& arm_kind() {
  static const ProblemKind kKind{
      .key = "arm_algorithms",
      .title = "Arms, see `lasius arm --help`",
      .plans = "for arms",
      .advice = "; use `lasius arm`",
      .commands = {"arm"},
      .algorithms = arm::algorithms(),
      .default_text = default_text<arm::Params>,
      .formulas = formulas_of<arm::Params>,
      .format = kArmFormat,
      .again = [](const Recorded& from, const Problem*) -> std::unique_ptr<Problem> {
        return std::make_unique<ArmProblem>(recorded_command(from));
      },
      .unlike = unlike_lattice,
      .forget = forget_lattice,
      .counted =
          [](const Json& result) {
            const Json& given = value_at(result, "parameters");
            return given.contains("max_questions") && given["max_questions"] != 0 &&
                   value_at(given, "time_limit").is_null();
          }};
  return kKind;
}

int run_command(const ArmCommand& command) {
  ArmProblem problem(command);
  return run(problem);
}

}  // namespace lasius::tool
