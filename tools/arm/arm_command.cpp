#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/arm/arm_answer.h"
#include "tools/arm/arm_picture.h"
#include "tools/arm/arm_report.h"
#include "tools/bitmap/answer.h"
#include "tools/commands.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

std::string note(const arm::ArmProgress& view) {
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

void solve(const ArmCommand& command, const std::stop_token& token, ArmAnswer& answer) {
  const StopCondition stop{.token = token, .deadline = deadline_after(command.time_limit)};
  const bool shown = wants_progress(command.messages);
  ProgressLine bar(shown, answer.parameters.iterations, command.time_limit.value_or(0));
  arm::Observer observer;
  if (shown)
    observer = [&](const arm::ArmProgress& view) { bar.update(view.iteration + 1, note(view)); };
  solve_arm(command, stop, observer, answer);
}

/// Says what of an answer is not as one may expect.
void remark(const ArmCommand& command, const ArmAnswer& answer) {
  if (command.messages.quiet) return;
  const auto& motion = answer.plan;
  if (motion.stops)
    message(motion.status == Status::solved
                ? "the motion rests at each waypoint: no faster one between them was found free"
                : "the motion rests at each waypoint: there was no time to look for a faster one");
  if (sample_rate(motion.trajectory, command.rate) < command.rate)
    message("the motion takes " + whole_text(motion.trajectory.duration()) + " s: it is sampled " +
            whole_text(kMostSamples) + " times in all, not " + whole_text(command.rate) +
            " times a second");
}

void announce(const ArmCommand& command, const ArmAnswer& answer) {
  if (!command.messages.verbose) return;
  message(command.robot + ": " + counted(answer.robot.size(), "joint"));
  message(command.scene + ": " +
          counted(static_cast<std::int64_t>(answer.scene.obstacles.size()), "obstacle"));
  message("goritov2020, seed " + std::to_string(command.seed) + ", " +
          counted(command.threads, "thread"));
}

}  // namespace

int run_arm(const ArmCommand& command) {
  for (const auto& file : command.outputs) check_writable(file);
  SignalWatcher signals;
  ArmAnswer answer = prepare_arm(command);
  announce(command, answer);
  solve(command, signals.token(), answer);

  const Outcome ended{.status = answer.plan.status,
                      .iterations = answer.plan.iterations,
                      .has_path = answer.plan.joints.cols() > 0,
                      .error = answer.plan.error};
  report(ended, command.messages);
  remark(command, answer);
  if (answer.recheck && !command.json && !command.messages.quiet)
    message(recheck_text(*answer.recheck));
  const Forms forms{
      .text = [&] { return arm_text(answer); },
      .json = [&] { return line(arm_json(command, answer)); },
      .csv = [&] { return arm_csv(command, answer); },
      .write_picture = [&](const std::string& file) { write_arm_picture(file, command, answer); }};
  deliver(forms, command.json, command.outputs, command.messages);
  return exit_code(ended);
}

}  // namespace lasius::tool
