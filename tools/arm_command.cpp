#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "answer.h"
#include "arm_picture.h"
#include "arm_report.h"
#include "commands.h"
#include "elapsed.h"
#include "outputs.h"
#include "progress.h"
#include "signals.h"
#include "streams.h"

namespace lasius::tool {
namespace {

/// FNV-1a of a file that was just read.
std::uint64_t file_hash(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (char c = 0; in.get(c);) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

ArmAnswer prepare(const ArmCommand& command) {
  ArmAnswer answer;
  for (const auto& [name, value] : command.settings)
    arm::set_parameter(answer.parameters, name, value);
  answer.parameters.seed = command.seed;
  answer.parameters.threads = command.threads;
  arm::validate(answer.parameters);
  answer.robot =
      arm::read_robot(command.robot, {.base = command.base_link, .tip = command.tip_link});
  answer.robot_hash = file_hash(command.robot);
  answer.scene = arm::read_scene(command.scene);
  answer.scene_hash = file_hash(command.scene);
  answer.clearance = command.clearance > 0 ? command.clearance : arm::SceneSensor::kClearance;
  return answer;
}

std::string note(const arm::IterationView& view) {
  std::array<char, 96> text;
  const auto questions = view.questions.positions + view.questions.motions;
  if (std::isfinite(view.best_length))
    std::snprintf(text.data(), text.size(), "best %.3f m, %lld questions", view.best_length,
                  static_cast<long long>(questions));
  else
    std::snprintf(text.data(), text.size(), "no path yet, %lld questions",
                  static_cast<long long>(questions));
  return text.data();
}

void solve(const ArmCommand& command, const arm::SceneSensor& sensor, const std::stop_token& token,
           ArmAnswer& answer) {
  const StopCondition stop{.token = token, .deadline = deadline_after(command.time_limit)};
  const bool shown = wants_progress(command.messages);
  ProgressLine bar(shown, answer.parameters.iterations, command.time_limit.value_or(0));
  arm::Observer observer;
  if (shown)
    observer = [&](const arm::IterationView& view) { bar.update(view.iteration + 1, note(view)); };
  const auto begin = Clock::now();
  const arm::Request request{.start = command.start,
                             .goal = {command.goal[0], command.goal[1], command.goal[2]},
                             .stop = stop,
                             .target_gap = command.target_gap};
  answer.plan = arm::plan(answer.robot, sensor, request, answer.parameters, observer);
  answer.motion = arm::make_trajectory(answer.robot, sensor, answer.plan.joints,
                                       {.shortcut = answer.parameters.shortcut, .stop = stop});
  answer.elapsed_ms = ms_since(begin);
  if (command.recheck > 0 && !answer.motion.trajectory.empty())
    answer.recheck =
        arm::recheck(answer.robot, answer.scene, answer.motion.trajectory, command.recheck);
}

/// Says what is touched where the library only knows that something is.
void name_contact(const ArmCommand& command, const arm::SceneSensor& sensor, ArmAnswer& answer) {
  if (answer.plan.status != Status::invalid || !answer.plan.error.ends_with("at the start")) return;
  answer.plan.error += ": " + sensor.contact(command.start);
}

void announce(const ArmCommand& command, const ArmAnswer& answer) {
  if (!command.messages.verbose) return;
  message(command.robot + ": " + std::to_string(answer.robot.size()) + " joints");
  message(command.scene + ": " + std::to_string(answer.scene.obstacles.size()) + " obstacles");
  message("goritov2020, seed " + std::to_string(command.seed) + ", " +
          std::to_string(command.threads) + " threads");
}

}  // namespace

int run_arm(const ArmCommand& command) {
  for (const auto& file : command.outputs) check_writable(file);
  SignalWatcher signals;
  ArmAnswer answer = prepare(command);
  announce(command, answer);
  const arm::SceneSensor sensor(answer.robot, answer.scene, answer.clearance);
  solve(command, sensor, signals.token(), answer);
  name_contact(command, sensor, answer);

  const Outcome ended{.status = answer.plan.status,
                      .iterations = answer.plan.iterations,
                      .has_path = !answer.plan.joints.empty(),
                      .error = answer.plan.error};
  report(ended, command.messages);
  if (answer.motion.stops && !command.messages.quiet)
    message("the motion rests at each waypoint: no faster one between them was found free");
  const Forms forms{
      .text = [&] { return arm_text(answer); },
      .json = [&] { return line(arm_json(command, answer)); },
      .csv = [&] { return arm_csv(command, answer); },
      .write_picture = [&](const std::string& file) { write_arm_picture(file, command, answer); }};
  deliver(forms, command.json, command.outputs, command.messages);
  return exit_code(ended);
}

}  // namespace lasius::tool
