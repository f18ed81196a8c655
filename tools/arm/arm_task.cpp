#include "tools/arm/arm_task.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/arm/arm_answer.h"
#include "tools/arm/arm_picture.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

constexpr double kMostSamples = 1e6;

/// FNV-1a of a file that was just read.
std::uint64_t file_hash(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (char c = 0; in.get(c);) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// Samples a second of a trajectory: as many as wanted, kMostSamples in all at most.
double sample_rate(const arm::Trajectory& trajectory, double wanted) {
  return trajectory.duration() * wanted <= kMostSamples ? wanted
                                                        : kMostSamples / trajectory.duration();
}

/// Times at which a trajectory is told: so many a second, and its end.
std::vector<double> sample_times(const arm::Trajectory& trajectory, double wanted) {
  const double rate = sample_rate(trajectory, wanted);
  const double count = std::floor(trajectory.duration() * rate);
  std::vector<double> times;
  for (double i = 0; i <= count; ++i) times.push_back(std::min(i / rate, trajectory.duration()));
  if (times.back() < trajectory.duration()) times.push_back(trajectory.duration());
  return times;
}

Json position(const Eigen::Vector3d& p) { return {number(p.x()), number(p.y()), number(p.z())}; }

Json joint_values(const arm::JointRef& q) {
  return numbers(std::vector<double>(q.begin(), q.end()));
}

Json trajectory_json(const ArmAnswer& answer, double rate) {
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  if (trajectory.empty()) return nullptr;
  Json knots = {{"t", Json::array()}, {"q", Json::array()}, {"ddq", Json::array()}};
  for (const auto& knot : trajectory.knots()) {
    knots["t"].push_back(number(knot.time));
    knots["q"].push_back(joint_values(knot.q));
    knots["ddq"].push_back(joint_values(knot.ddq));
  }
  Json samples = {{"t", Json::array()},
                  {"q", Json::array()},
                  {"dq", Json::array()},
                  {"ddq", Json::array()},
                  {"tip", Json::array()}};
  for (const double t : sample_times(trajectory, rate)) {
    const auto state = trajectory.at(t);
    samples["t"].push_back(number(t));
    samples["q"].push_back(joint_values(state.q));
    samples["dq"].push_back(joint_values(state.dq));
    samples["ddq"].push_back(joint_values(state.ddq));
    samples["tip"].push_back(position(arm::tip_position(answer.robot, state.q)));
  }
  return {{"duration", number(trajectory.duration())},
          {"waypoints", answer.plan.waypoints},
          {"stops", answer.plan.stops},
          {"knots", knots},
          {"samples", samples}};
}

/// `lasius arm`.
class ArmTask : public Task {
 public:
  explicit ArmTask(ArmCommand command) : command_(std::move(command)) {}

  void open() override {
    found_.parameters =
        make_params<arm::Params>(command_, World::Kind::arm, arm::algorithms(), command_.notes);
    found_.robot =
        arm::read_robot(command_.robot, {.base = command_.base_link, .tip = command_.tip_link});
    found_.robot_hash = file_hash(command_.robot);
    const auto values = static_cast<std::int64_t>(command_.start.size());
    if (values != found_.robot.size())
      throw UsageError("--start gives " + counted(values, "joint value") + ", " + command_.robot +
                       " has " + counted(found_.robot.size(), "joint"));
    found_.scene = arm::read_scene(command_.scene);
    found_.scene_hash = file_hash(command_.scene);
    found_.clearance = command_.clearance > 0 ? command_.clearance : arm::SceneSensor::kClearance;
  }
  void announce() const override {
    Task::announce();
    if (!command_.messages.verbose) return;
    message(command_.robot + ": " + counted(found_.robot.size(), "joint"));
    message(command_.scene + ": " +
            counted(static_cast<std::int64_t>(found_.scene.obstacles.size()), "obstacle"));
    announce_algorithm(true);
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const arm::SceneSensor sensor(found_.robot, found_.scene, found_.clearance);
    const auto begin = Clock::now();
    const auto& [x, y, z] = command_.goal;
    const arm::Request request{.start = joint_vector(command_.start),
                               .goal = {x, y, z},
                               .stop = stop,
                               .target_gap = command_.target_gap};
    arm::Result& plan = found_.plan;
    plan = arm::plan(found_.robot, sensor, request, found_.parameters, watch);
    found_.elapsed_ms = ms_since(begin);
    if (command_.recheck > 0 && !plan.trajectory.empty())
      found_.recheck = arm::recheck(found_.robot, found_.scene, plan.trajectory, command_.recheck);
  }

  const SearchOptions& options() const override { return command_; }
  std::vector<std::string> input_files() const override {
    std::vector<std::string> files = found_.robot.meshes;
    for (const auto& obstacle : found_.scene.obstacles) files.push_back(obstacle.file);
    files.insert(files.end(), {command_.robot, command_.scene});
    return files;
  }
  const Algorithm& algorithm() const override {
    return arm::find_algorithm(arm::Params::algorithm());
  }
  std::string parameter(std::string_view name) const override {
    return get_parameter(found_.parameters, name);
  }
  std::int64_t iterations() const override { return found_.parameters.iterations; }

  const SearchResult& result() const override { return found_.plan; }
  double elapsed_ms() const override { return found_.elapsed_ms; }

  std::string unit() const override { return "m"; }
  std::string progress_note(const Progress& progress) const override {
    const auto asked = static_cast<const arm::ArmProgress&>(progress).questions;
    return Task::progress_note(progress) + ", " +
           counted(asked.positions + asked.motions, "question");
  }
  /// What of the motion is not as one may expect.
  void remark() const override {
    const arm::Result& motion = found_.plan;
    if (motion.stops)
      message(
          motion.status == Status::solved
              ? "the motion rests at each waypoint: no faster one between them was found free"
              : "the motion rests at each waypoint: there was no time to look for a faster one");
    if (sample_rate(motion.trajectory, command_.rate) < command_.rate)
      message("the motion takes " + whole_text(motion.trajectory.duration()) +
              " s: it is sampled " + whole_text(kMostSamples) + " times in all, not " +
              whole_text(command_.rate) + " times a second");
    if (!found_.recheck || command_.json) return;
    message("recheck: " + counted(found_.recheck->samples, "sample") + ", " +
            counted(found_.recheck->contacts, "contact") + ", " +
            counted(found_.recheck->limits, "broken limit") + ", nearest " +
            to_text(found_.recheck->nearest) + " m");
  }
  /// Of the tip, a lattice point a line.
  void write_path(std::ostream& out, const char* between) const override {
    for (const Eigen::Vector3d p : found_.plan.tips.colwise())
      out << to_text(p.x()) << between << to_text(p.y()) << between << to_text(p.z()) << "\n";
  }
  /// Header, and a row a sample: t, q1.., dq1.., ddq1.., x, y, z.
  void write_csv(std::ostream& out) const override {
    out << "t";
    for (const char* name : {"q", "dq", "ddq"})
      for (int j = 1; j <= found_.robot.size(); ++j) out << "," << name << j;
    out << ",x,y,z\n";
    const arm::Trajectory& trajectory = found_.plan.trajectory;
    if (trajectory.empty()) return;
    for (const double t : sample_times(trajectory, command_.rate)) {
      const auto state = trajectory.at(t);
      out << to_text(t);
      for (const auto* values : {&state.q, &state.dq, &state.ddq})
        for (const double value : *values) out << "," << to_text(value);
      for (const double value : arm::tip_position(found_.robot, state.q))
        out << "," << to_text(value);
      out << "\n";
    }
  }
  void write_picture(const std::string& file) const override {
    write_arm_picture(file, command_, found_);
  }

  const char* format() const override { return kArmFormat; }
  Json inputs() const override {
    return {{"robot",
             {{"file", command_.robot},
              {"hash", hash_text(found_.robot_hash)},
              {"base_link", text_or_null(command_.base_link)},
              {"tip_link", text_or_null(command_.tip_link)},
              {"name", found_.robot.name},
              {"joints", found_.robot.size()}}},
            {"scene",
             {{"file", command_.scene},
              {"hash", hash_text(found_.scene_hash)},
              {"name", found_.scene.name},
              {"obstacles", found_.scene.obstacles.size()}}}};
  }
  std::pair<Json, Json> ends() const override {
    return {numbers(command_.start), numbers({command_.goal.begin(), command_.goal.end()})};
  }
  void add_settings(Json& json) const override {
    json["clearance"] = number(found_.clearance);
    add_limits(json);
    json["rate"] = number(command_.rate);
  }
  void add_path(Json& json) const override {
    const arm::Result& plan = found_.plan;
    json["path"] = nullptr;
    json["joints"] = nullptr;
    for (const Eigen::Vector3d tip : plan.tips.colwise()) json["path"].push_back(position(tip));
    for (const auto q : plan.joints.colwise()) json["joints"].push_back(joint_values(q));
    json["lattice"] = {{"pitch", number(plan.pitch)}, {"points", plan.points}};
  }
  void add_effort(Json& json) const override {
    json["questions"] = {{"positions", found_.plan.questions.positions},
                         {"motions", found_.plan.questions.motions},
                         {"trajectory", found_.plan.questions.trajectory}};
  }
  void add_findings(Json& json) const override {
    json["trajectory"] = trajectory_json(found_, command_.rate);
    if (const auto& recheck = found_.recheck)
      json["recheck"] = {{"samples", recheck->samples},
                         {"contacts", recheck->contacts},
                         {"limits", recheck->limits},
                         {"nearest", number(recheck->nearest)},
                         {"tip_error", number(recheck->tip_error)}};
  }

 private:
  ArmCommand command_;
  ArmAnswer found_;
};

}  // namespace

std::unique_ptr<Task> recorded_arm(const Recorded& from) {
  const Json& result = from.result;
  ArmCommand command;
  read_recorded(from, arm::find_algorithm(arm::Params::algorithm()), command);
  command.robot = from.found(recorded<std::string>(result, "robot/file"));
  command.scene = from.found(recorded<std::string>(result, "scene/file"));
  command.base_link = recorded_optional<std::string>(result, "robot/base_link").value_or("");
  command.tip_link = recorded_optional<std::string>(result, "robot/tip_link").value_or("");
  command.start = recorded<std::vector<double>>(result, "start");
  command.goal = recorded<std::array<double, 3>>(result, "goal");
  command.clearance = recorded_real(result, "parameters/clearance", ArmCommand::kLeastClearance,
                                    ArmCommand::kMostClearance);
  command.rate =
      recorded_real(result, "parameters/rate", ArmCommand::kLeastRate, ArmCommand::kMostRate);
  if (result.contains("recheck"))
    command.recheck =
        static_cast<int>(recorded_integer(result, "recheck/samples", 1, ArmCommand::kMostRecheck));
  return std::make_unique<ArmTask>(std::move(command));
}

int run_arm(const ArmCommand& command) {
  ArmTask task(command);
  return run(task);
}

}  // namespace lasius::tool
