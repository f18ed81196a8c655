// lasius study, lasius tune.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <tuple>

#include "tools/command_line/option_kinds.h"
#include "tools/command_line/run_text.h"
#include "tools/command_line/subcommands.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"
#include "tools/yaml/document.h"
#include "tools/yaml/preset_file.h"

namespace lasius::tool {
namespace {

/// What only `study run` takes, as typed.
struct ShortText {
  std::string map, start, goal, frame, radius, algorithms, preset, steps, time_limit;
  std::vector<std::string> set;
};

struct StudyText {
  std::string name, seeds, folder, threads, maps;
  bool quiet = false;
  ShortText run;
};

std::vector<std::string> values_in(const std::string& option, const std::string& text,
                                   std::size_t from = 0) {
  const auto parts = split(std::string_view(text).substr(from), ',');
  if (std::ranges::find(parts, "") != parts.end())
    throw UsageError(option + " " + text + ": a value is missing");
  return {parts.begin(), parts.end()};
}

/// NAME=VALUE,VALUE..., each tried with every algorithm that has the parameter.
std::pair<std::string, std::vector<std::string>> factor_of(
    const std::string& setting, const std::vector<std::string>& algorithms) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos)
    throw UsageError("--set " + setting + ": not of the form NAME=VALUE,VALUE");
  const std::string name = setting.substr(0, equals);
  auto values = values_in("--set", setting, equals + 1);
  for (const std::string& value : values)
    if (std::ranges::count(values, value) > 1)
      throw UsageError("--set " + setting + ": " + value + " is given twice");
  bool known = false;
  for (const std::string& algorithm : algorithms) {
    if (!find_algorithm(algorithm).has(name)) continue;
    known = true;
    Params params(algorithm);
    for (const std::string& value : values) set_parameter(params, name, value);
  }
  if (!known)  // the message names the nearest
    (void)setting_of(setting, find_algorithm(algorithms.front()), lasius::algorithms());
  return {name, std::move(values)};
}

ShortStudy short_study(const ShortText& text) {
  if (text.map.empty()) throw UsageError("study run: MAP is required; see --help");
  if (is_world(text.map))
    throw UsageError("study run: " + text.map +
                     " is a polygon world; own studies plan on bitmaps alone");
  if (text.start.empty()) throw UsageError("study run: --start is required; see --help");
  if (text.goal.empty()) throw UsageError("study run: --goal is required; see --help");
  const Frame frame = frame_of(text.frame);
  const auto end = [&](const char* option, const std::string& value) {
    const Point p = end_value(option, value, frame, text.map);
    constexpr double kOutside = 1e9;  // outside of every map
    return Point{std::clamp(p.x, -kOutside, kOutside), std::clamp(p.y, -kOutside, kOutside)};
  };
  ShortStudy run{.map = text.map,
                 .start = end("--start", text.start),
                 .goal = end("--goal", text.goal),
                 .frame = frame,
                 .algorithms = {},
                 .preset = text.preset,
                 .factors = {},
                 .steps = {},
                 .seconds = {}};
  if (!text.algorithms.empty())
    run.algorithms = values_in("--algorithm", text.algorithms);
  else if (is_document(text.preset))
    run.algorithms = {read_preset_file(text.preset).algorithm};
  else
    throw UsageError("study run: --algorithm is required; see --help");
  for (const std::string& algorithm : run.algorithms) {
    (void)algorithm_of(bitmaps(), algorithm);
    if (std::ranges::count(run.algorithms, algorithm) > 1)
      throw UsageError("--algorithm " + text.algorithms + ": " + algorithm + " is given twice");
  }
  if (!text.preset.empty() && !is_document(text.preset))
    (void)choice_value("--preset", text.preset, kPresetNames);
  refuse_repeats(text.set);
  for (const std::string& setting : text.set)
    run.factors.push_back(factor_of(setting, run.algorithms));
  if (!text.radius.empty()) run.radius = real_value("--radius", text.radius, 0, kNoLimit);
  if (!text.steps.empty()) run.steps = real_value("--steps", text.steps, 1, 1e15);
  if (!text.time_limit.empty())
    run.seconds = real_value("--time-limit", text.time_limit, 1e-6, 1e9);
  return run;
}

void refuse_short_options(const ShortText& text, const std::string& name) {
  const char* option = !text.map.empty()          ? "a second argument"
                       : !text.start.empty()      ? "--start"
                       : !text.goal.empty()       ? "--goal"
                       : !text.frame.empty()      ? "--frame"
                       : !text.radius.empty()     ? "--radius"
                       : !text.algorithms.empty() ? "--algorithm"
                       : !text.preset.empty()     ? "--preset"
                       : !text.steps.empty()      ? "--steps"
                       : !text.time_limit.empty() ? "--time-limit"
                       : !text.set.empty()        ? "--set"
                                                  : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) + " is for `lasius study run MAP`; what " + name +
                     " runs is in its file");
}

/// Where reports go unless -o says so: the file's name, or "run" for a map that is in none.
std::string usual_folder(const std::string& prefix, const std::string& file) {
  std::error_code ignored;
  const bool there = is_document(file) || std::filesystem::exists(file, ignored);
  return prefix + (there ? std::filesystem::path(file).stem().string() : "run");
}

void read_seeds(const std::string& text, StudyCommand& command) {
  if (text.empty()) return;
  std::tie(command.first_seed, command.seeds) = seed_range("--seeds", text, 1);
}

StudyCommand make_study(const StudyText& text) {
  StudyCommand command{.name = text.name,
                       .threads = thread_count(text.threads),
                       .folder = text.folder,
                       .maps = text.maps};
  const bool run = text.name == "run";
  if (run)
    command.run = short_study(text.run);
  else
    refuse_short_options(text.run, text.name);
  if (text.folder.empty())
    command.folder = run || is_document(text.name)
                         ? usual_folder("study-", run ? text.run.map : text.name)
                         : "study-" + text.name;
  read_seeds(text.seeds, command);
  command.messages.quiet = text.quiet;
  return command;
}

}  // namespace

Subcommand add_study(CLI::App& app) {
  auto raw = std::make_shared<StudyText>();
  auto* study = app.add_subcommand("study", "Run a study: a source's, your own, or a sweep");
  study
      ->add_option("NAME", raw->name,
                   "A study that the program holds, or FILE.yaml; run: a sweep on MAP; list: what "
                   "there is; all: each of them, and one table of claims")
      ->required();
  const AddOption option = option_adder(*study);
  option("MAP", raw->run.map, "With run: the map, a file or \"KIND WxH DENSITY SEED\"", "FILE");
  option("--seeds", raw->seeds, "Seeds of the runs, 1 to N or A to B (default: the study's own)",
         "N|A-B|A..B");
  option(
      "-o,--output", raw->folder,
      "Folder to write (default study-NAME); FILE.html: that page, and a folder FILE for the rest",
      "DIR|FILE.html");
  option("--threads", raw->threads, "Runs at a time", "N");
  option("--maps", raw->maps, "Folder of the maps, instead of the program's own", "DIR");
  option("--start", raw->run.start, "With run: where paths start", "X,Y");
  option("--goal", raw->run.goal, "With run: where they end", "X,Y");
  option("--frame", raw->run.frame, "With run: of --start, --goal and --radius, as plan has it",
         "cell|world");
  option("--radius", raw->run.radius, "With run: of the robot, a disc, as plan --radius has it",
         "R");
  option("--algorithm", raw->run.algorithms, "With run: the algorithms", "NAME,NAME");
  option("--preset", raw->run.preset, "With run: numbers to start with", "usual|book|FILE");
  add_repeatable(*study, "--set", raw->run.set,
                 "With run: values of a parameter; all combinations are run (repeatable)",
                 "NAME=VALUE,VALUE");
  option("--steps", raw->run.steps, "With run: end a run after so many steps of its ants", "N");
  option("--time-limit", raw->run.time_limit, "With run: end a run after this processor time",
         "SECONDS");
  add_switch(*study, "-q,--quiet", raw->quiet, "Print errors only");
  return {study, [raw]() -> Command { return make_study(*raw); }};
}

Subcommand add_tune(CLI::App& app) {
  auto raw = std::make_shared<StudyText>();
  auto* tune = app.add_subcommand("tune", "Find an algorithm's parameters for your maps by racing");
  const AddOption option = option_adder(*tune);
  option("FILE", raw->name, "What is tuned, and on which maps: see docs/studies.md", "FILE")
      ->required();
  option("-o,--output", raw->folder, "Folder to write (default tune-NAME)", "DIR");
  option("--threads", raw->threads, "Runs at a time", "N");
  option("--maps", raw->maps, "Folder of the maps, instead of the program's own", "DIR");
  add_switch(*tune, "-q,--quiet", raw->quiet, "Print errors only");
  return {tune, [raw]() -> Command {
            TuneCommand command{
                .file = raw->name,
                .threads = thread_count(raw->threads),
                .folder = raw->folder.empty() ? usual_folder("tune-", raw->name) : raw->folder,
                .maps = raw->maps};
            command.messages.quiet = raw->quiet;
            return command;
          }};
}

}  // namespace lasius::tool
