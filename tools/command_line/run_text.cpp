#include "tools/command_line/run_text.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/output.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/picture.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

template <class Text>
Messages messages_of(const Text& text) {
  static constexpr std::string_view kModes[] = {"auto", "always", "never"};
  if (text.quiet && text.verbose) throw UsageError("-q and -v exclude each other");
  Messages messages{.quiet = text.quiet, .verbose = text.verbose};
  if (!text.progress.empty())
    messages.progress =
        static_cast<ProgressMode>(choice_value("--progress", text.progress, kModes));
  return messages;
}

}  // namespace

Messages make_messages(const RunText& text) { return messages_of(text); }

std::string& RunText::value_of(std::string_view name) {
  for (auto& [known, value] : named)
    if (known == name) return value;
  throw std::logic_error("no option of this name");
}

std::uint64_t seed_value(const std::string& text) {
  if (text.empty()) return 1;
  return static_cast<std::uint64_t>(integer_value("--seed", text, 0, kMaxExactInteger));
}

std::optional<double> time_limit_value(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return real_value("--time-limit", text, 0, kNoLimit);
}

double target_gap_value(const std::string& text) {
  return text.empty() ? 0 : real_value("--target-gap", text, 0, kNoLimit) / 100;
}

void check_endings(const std::vector<std::string>& files,
                   std::span<const std::string_view> endings) {
  for (const auto& file : files) {
    if (std::ranges::any_of(endings, [&](auto ending) { return has_ending(file, ending); }))
      continue;
    const auto dot = file.find_last_of("./");
    const bool dotted = dot != std::string::npos && file[dot] == '.';
    choice_value("-o " + file, dotted ? file.substr(dot) : "", endings);
  }
}

RunOptions make_run(const RunText& text) {
  RunOptions run;
  run.map.file = text.map;
  run.params = default_params(text.algorithm);
  for (const auto& [name, value] : text.named)
    if (!value.empty() && !set_common(run.params, name, value))
      run.notes.push_back("--" + name + " has no effect: " + run.params.algorithm() +
                          " has no such parameter");
  for (const auto& setting : text.set) set_named(run.params, setting);
  validate(run.params);
  run.params.seed = seed_value(text.seed);
  run.params.threads = thread_count(text.threads);
  run.time_limit = time_limit_value(text.time_limit);
  run.target_gap = target_gap_value(text.target_gap);
  if (!text.frame.empty())
    run.frame = static_cast<Frame>(choice_value("--frame", text.frame, kFrames));
  if (!text.radius.empty()) run.map.radius = real_value("--radius", text.radius, 0, kNoLimit);
  run.map.radius_metres = run.frame == Frame::world;
  run.map.unknown_is_free = text.unknown_free;
  const auto& file = run.map.file;
  if (text.unknown_free && !has_ending(file, ".yaml") && !has_ending(file, ".yml"))
    run.notes.push_back("--unknown-free has no effect: only ROS maps (.yaml) have unknown cells");
  if (run.target_gap > 0 && moves_on_cells(run))
    run.notes.push_back("--target-gap has no effect: " + run.params.algorithm() +
                        " certifies no gap");
  run.with_optimum = text.gap;
  run.map.prepare = text.prepare && (run.with_optimum || !moves_on_cells(run));
  run.map.threads = run.params.threads;
  if (text.prepare && !run.map.prepare)
    run.notes.push_back("--prepare has no effect: it is for exact, and for --gap");
  run.json = text.json;
  check_endings(text.outputs, kOutputEndings);
  run.outputs = text.outputs;
  if (!text.tracks.empty() && std::none_of(run.outputs.begin(), run.outputs.end(), is_picture))
    run.notes.push_back("--tracks has no effect without -o of a picture, .svg or .png");
  run.track_iterations = list_value("--tracks", text.tracks.empty() ? "10,50,120" : text.tracks);
  run.messages = messages_of(text);
  return run;
}

ArmCommand make_arm(const ArmText& text) {
  static constexpr std::string_view kAlgorithms[] = {"goritov2020"};
  ArmCommand arm{.robot = text.robot,
                 .base_link = text.base,
                 .tip_link = text.tip,
                 .scene = text.scene,
                 .start = reals_value("--start", text.start, 1, 16),
                 .threads = thread_count(text.threads),
                 .json = text.json,
                 .outputs = text.outputs,
                 .messages = messages_of(text)};
  const auto goal = reals_value("--goal", text.goal, 3, 3);
  arm.goal = {goal[0], goal[1], goal[2]};
  if (!text.algorithm.empty()) choice_value("--algorithm", text.algorithm, kAlgorithms);
  for (const auto& [name, value] : text.named)
    if (!value.empty()) arm.settings.emplace_back(name, value);
  if (text.plain) arm.settings.emplace_back("shortcut", "off");
  for (const auto& setting : text.set) {
    refuse_option(setting);
    arm.settings.emplace_back(setting_parts(setting));
  }
  arm.seed = seed_value(text.seed);
  arm.time_limit = time_limit_value(text.time_limit);
  arm.target_gap = target_gap_value(text.target_gap);
  if (!text.clearance.empty())
    arm.clearance = real_value("--clearance", text.clearance, ArmCommand::kLeastClearance,
                               ArmCommand::kMostClearance);
  if (!text.rate.empty())
    arm.rate = real_value("--rate", text.rate, ArmCommand::kLeastRate, ArmCommand::kMostRate);
  if (!text.recheck.empty())
    arm.recheck =
        static_cast<int>(integer_value("--recheck", text.recheck, 1, ArmCommand::kMostRecheck));
  check_endings(text.outputs, kOutputEndings);
  return arm;
}

}  // namespace lasius::tool
