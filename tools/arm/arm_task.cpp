#include "tools/arm/arm_task.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/arm/arm_answer.h"
#include "tools/arm/arm_json.h"
#include "tools/arm/arm_picture.h"
#include "tools/arm/arm_recorded.h"
#include "tools/arm/arm_report.h"
#include "tools/arm/arm_samples.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"

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

/// `lasius arm`.
class ArmTask : public Task {
 public:
  explicit ArmTask(ArmCommand command) : command_(std::move(command)) {}

  void open() override {
    found_.parameters =
        make_params<arm::Params>(command_, World::Kind::arm, arm::algorithms(), command_.notes);
    read_robot();
    found_.scene = arm::read_scene(command_.scene);
    found_.scene_file = hashed(command_.scene);
    found_.scene_files = hashed(files_of(found_.scene));
    found_.clearance = command_.clearance > 0 ? command_.clearance : arm::SceneSensor::kClearance;
    found_.start = joint_values("--start", command_.start, command_.start_state);
    for (const ArmGoal& goal : command_.goals) found_.goals.push_back(goal_of(goal));
  }
  void announce() const override {
    Task::announce();
    if (!command_.messages.verbose) return;
    message(command_.robot + ": " + counted(found_.robot.size(), "joint"));
    announce_bodies();
    message(command_.scene + ": " + counted(found_.scene.obstacles.size(), "obstacle"));
    announce_algorithm(true);
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const arm::SceneSensor sensor(found_.robot, found_.scene, found_.clearance);
    const auto begin = Clock::now();
    const arm::Request request{.start = found_.start,
                               .goals = found_.goals,
                               .stop = stop,
                               .target_gap = command_.target_gap,
                               .duration = command_.duration};
    arm::Result& plan = found_.plan;
    plan = arm::plan(found_.robot, sensor, request, found_.parameters, watch);
    found_.elapsed_ms = ms_since(begin);
    if (command_.recheck <= 0 || plan.trajectory.empty()) return;
    const auto recheck = arm::recheck(found_.robot, found_.scene, plan.trajectory, command_.recheck,
                                      {.token = stop.token});
    if (recheck.samples == command_.recheck) found_.recheck = recheck;
  }

  const SearchOptions& options() const override { return command_; }
  std::vector<std::string> input_files() const override {
    std::vector<std::string> files = files_of(found_.scene);
    files.insert(files.end(), found_.robot.files.begin(), found_.robot.files.end());
    for (const auto* file :
         {&command_.robot, &command_.scene, &command_.srdf, &command_.joint_limits})
      if (!file->empty()) files.push_back(*file);
    return files;
  }
  const Algorithm& algorithm() const override {
    return arm::find_algorithm(found_.parameters.algorithm());
  }
  std::string parameter(std::string_view name) const override {
    return get_parameter(found_.parameters, name);
  }
  std::int64_t iterations() const override { return found_.parameters.iterations; }

  const SearchResult& result() const override { return found_.plan; }
  double elapsed_ms() const override { return found_.elapsed_ms; }

  std::string unit() const override { return unit_of(found_.parameters.objective); }
  std::string progress_note(const Progress& progress) const override {
    const auto asked = static_cast<const arm::ArmProgress&>(progress).questions;
    return Task::progress_note(progress) + ", " +
           counted(asked.positions + asked.motions, "question");
  }
  /// What of the motion is not as one may expect, and what it takes for granted.
  void remark() const override {
    const arm::Result& motion = found_.plan;
    for (const auto* notes :
         {&found_.robot.notes, &found_.robot.warnings, &found_.scene.warnings, &motion.notes})
      for (const std::string& note : *notes) message(note);
    if (found_.parameters.objective == arm::Objective::duration && motion.duration > 0)
      message("the motion takes " + to_text(motion.duration) + " s; " + to_text(motion.length) +
              " s is what its way takes at the joints' largest velocities throughout");
    if (motion.stops)
      message(std::string("the motion rests at each waypoint: ") +
              (motion.status == Status::solved ? "no faster one between them was found free"
               : motion.limit == Limit::questions
                   ? "no questions were left to look for a faster one"
                   : "there was no time to look for a faster one"));
    if (command_.duration > 0 && motion.duration > command_.duration)
      message("the motion takes " + to_text(motion.duration) +
              " s, as the joints' limits ask, not " + to_text(command_.duration) + " s");
    if (sample_rate(motion.trajectory, command_.rate) < command_.rate)
      message("the motion takes " + whole_text(motion.trajectory.duration()) +
              " s: it is sampled " + whole_text(kMostSamples) + " times in all, not " +
              whole_text(command_.rate) + " times a second");
    if (command_.recheck > 0 && !found_.recheck && !motion.trajectory.empty())
      message("the recheck was interrupted");
    if (!found_.recheck || command_.json) return;
    message("recheck: " + counted(found_.recheck->samples, "sample") + ", " +
            counted(found_.recheck->contacts, "contact") + ", " +
            counted(found_.recheck->limits, "broken limit") + ", nearest " +
            to_text(found_.recheck->nearest) + " m; between them " +
            (found_.recheck->unproven == 0
                 ? "nothing is touched either"
                 : counted(found_.recheck->unproven, "piece") + " could not be shown to be free"));
  }
  /// Of the tip, a lattice point a line.
  void write_path(std::ostream& out, const char* between) const override {
    for (const Eigen::Vector3d p : found_.plan.tips.colwise())
      out << to_text(p.x()) << between << to_text(p.y()) << between << to_text(p.z()) << "\n";
  }
  void write_csv(std::ostream& out) const override {
    tool::write_csv(out, found_.robot, found_.plan.trajectory, command_.rate);
  }
  void write_yaml(std::ostream& out) const override {
    write_ros_trajectory(out, found_.robot, found_.plan.trajectory, command_.rate);
  }
  void write_picture(const std::string& file) const override {
    write_arm_picture(file, command_, found_);
  }

  void write_report(std::ostream& out) const override {
    write_arm_report(out, *this, command_, found_);
  }

  const char* format() const override { return kArmFormat; }
  Json inputs() const override {
    return {{"robot", robot_json(command_, found_)}, {"scene", scene_json(command_, found_)}};
  }
  /// The goal is where the tip goes: at the goal that was reached, or else the first.
  std::pair<Json, Json> ends() const override {
    const auto goal = static_cast<std::size_t>(std::max(0, found_.plan.goal));
    return {joint_values_json(found_.start), vector_json(tip_of(found_.robot, found_.goals[goal]))};
  }
  void add_settings(Json& json) const override {
    json["clearance"] = number(found_.clearance);
    add_limits(json);
    json["rate"] = number(command_.rate);
    json["duration"] = command_.duration > 0 ? number(command_.duration) : Json(nullptr);
    json["use_visual"] = command_.visual;
    json["bodiless"] = command_.bodiless;
    json["allow_contact"] = command_.contacts;
    json["set_joint"] = Json::object();
    for (const auto& [name, value] : command_.joint_values) json["set_joint"][name] = number(value);
  }
  void add_path(Json& json) const override {
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
    json["tip_travel"] = found ? number(plan.tip_travel) : Json(nullptr);
    json["joint_travel"] = found ? number(plan.joint_travel) : Json(nullptr);
    json["duration"] = plan.trajectory.empty() ? Json(nullptr) : number(plan.duration);
    json["notes"] = plan.notes;
    json["lattice"] = {
        {"pitch", number(plan.pitch)}, {"points", plan.points}, {"postures", plan.postures}};
  }
  void add_effort(Json& json) const override { json["questions"] = questions_json(found_.plan); }
  void add_findings(Json& json) const override {
    json["trajectory"] = trajectory_json(found_, command_.rate);
    if (const auto& recheck = found_.recheck)
      json["recheck"] = {
          {"samples", recheck->samples},   {"contacts", recheck->contacts},
          {"limits", recheck->limits},     {"nearest", number(recheck->nearest)},
          {"unproven", recheck->unproven}, {"tip_error", number(recheck->tip_error)}};
  }

 private:
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
  void announce_bodies() const {
    const auto joints = joint_names(found_.robot);
    const auto links = link_names(found_.robot);
    for (std::size_t i = 0; i < links.size(); ++i) {
      const arm::Link& link = found_.robot.links[i];
      std::string text = "body " + links[i] + ", " +
                         (link.body == 0 ? "stands still" : "moves with " + joints[link.body - 1]);
      for (const arm::Solid& solid : link.solids)
        text +=
            std::string(&solid == link.solids.data() ? ": " : ", ").append(to_string(solid.shape));
      message(text);
    }
    for (const arm::LinkPair& pair : arm::link_pairs(found_.robot))
      message("pair " + links[pair.first] + ", " + links[pair.second] + ": " +
              (pair.check == arm::LinkPair::Check::yes ? "" : "not checked, ") +
              std::string(to_string(pair.check)));
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

  ArmCommand command_;
  ArmAnswer found_;
};

}  // namespace

std::unique_ptr<Task> recorded_arm(const Recorded& from) {
  return std::make_unique<ArmTask>(recorded_command(from));
}

int run_command(const ArmCommand& command) {
  ArmTask task(command);
  return run(task);
}

}  // namespace lasius::tool
