#include "tools/command_line/run_text.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"
#include "tools/yaml/document.h"
#include "tools/yaml/preset_file.h"

namespace lasius::tool {
namespace {

Messages make_messages(const SearchText& text) {
  static constexpr std::string_view kModes[] = {"auto", "always", "never"};
  if (text.quiet && text.verbose) throw UsageError("-q and -v exclude each other");
  Messages messages{.quiet = text.quiet, .verbose = text.verbose};
  if (!text.progress.empty())
    messages.progress =
        static_cast<ProgressMode>(choice_value("--progress", text.progress, kModes));
  return messages;
}

/// "N", or "A-B" or "A..B": seeds from A to B.
void read_seeds(const std::string& text, SearchOptions& options) {
  if (text.find("..") == std::string::npos && text.find('-', 1) == std::string::npos) {
    options.seed = seed_value(text);
    return;
  }
  std::tie(options.seed, options.seeds) = seed_range("--seed", text, 0);
  options.ranged = true;
}

/// The numbers of a preset's file, and its algorithm where none is named.
void take_preset(const SearchText& text, SearchOptions& options) {
  PresetFile preset = read_preset_file(text.preset);
  if (text.algorithm.empty()) options.algorithm = preset.algorithm;
  if (options.algorithm != preset.algorithm)
    throw UsageError("--preset " + text.preset + " is of " + preset.algorithm + ", not of " +
                     options.algorithm + "; leave --algorithm out");
  options.preset = preset.preset;
  options.preset_file = text.preset;
  options.preset_settings = std::move(preset.settings);
}

/// Reads a number within bounds, where an option gives one.
template <class Number>
void take_real(std::string_view option, const std::string& text, double least, double most,
               Number& to) {
  if (!text.empty()) to = real_value(option, text, least, most);
}

/// Reads what all commands that plan have.
void read_search(const SearchText& text, SearchOptions& options,
                 std::span<const std::string_view> endings = kResultEndings) {
  options.algorithm = text.algorithm;
  if (is_document(text.preset))
    take_preset(text, options);
  else if (!text.preset.empty())
    options.preset = static_cast<Preset>(choice_value("--preset", text.preset, kPresetNames));
  for (const auto& [name, value] : text.named)
    if (!value.empty()) options.named.emplace_back(name, value);
  refuse_repeats(text.set);
  options.settings = text.set;
  read_seeds(text.seed, options);
  options.threads = thread_count(text.threads);
  take_real("--time-limit", text.time_limit, 0, kNoLimit, options.time_limit);
  if (!text.target_gap.empty())
    options.target_gap = real_value("--target-gap", text.target_gap, 0, kNoLimit) / 100;
  options.json = text.json;
  check_endings(text.outputs, endings);
  options.outputs = text.outputs;
  const auto page = std::ranges::find_if(text.outputs, is_page);
  if (options.ranged && page != text.outputs.end())
    throw UsageError("-o " + *page + ": a report plays one run; give it one seed");
  options.messages = make_messages(text);
}

std::optional<Point> optional_point(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return pair_value(option, text, false);
}

/// "A=B" or "A,B": what is before and after the first `between`. @throws UsageError
std::pair<std::string, std::string> halves(const std::string& option, const std::string& text,
                                           char between, const char* form) {
  const auto at = text.find(between);
  if (at == std::string::npos || at == 0 || at + 1 == text.size())
    throw UsageError(option + " " + text + ": not of the form " + form);
  return {text.substr(0, at), text.substr(at + 1)};
}

/// Not a name: a number, or several.
bool is_numeric(const std::string& text) {
  return text.find(',') != std::string::npos || parse_real(text).has_value();
}

ArmGoal arm_goal(const std::string& option, const std::string& text) {
  if (option == "--goal-pose") return {ArmGoal::Kind::pose, reals_value(option, text, 6, 6), {}};
  if (option == "--goal-joints")
    return {ArmGoal::Kind::joints, reals_value(option, text, 1, 16), {}};
  if (option == "--goal-state") return {ArmGoal::Kind::joints, {}, text};
  return {ArmGoal::Kind::position, reals_value(option, text, 3, 3), {}};
}

/// What is to be known of the robot, beside files and links.
void read_robot_options(const ArmText& text, ArmCommand& arm) {
  const auto once = [](const char* option, const std::string& name, bool first) {
    if (!first) throw UsageError(std::string(option) + " " + name + " is given twice");
  };
  for (const auto& package : text.packages) {
    const auto [name, folder] = halves("--package", package, '=', "NAME=DIR");
    once("--package", name, arm.packages.emplace(name, folder).second);
  }
  for (const auto& contact : text.contacts)
    arm.contacts.push_back(halves("--allow-contact", contact, ',', "LINK,LINK"));
  for (const auto& joint : text.joint_values) {
    const auto [name, value] = halves("--set-joint", joint, '=', "NAME=VALUE");
    const double number = real_value("--set-joint " + name, value, -kNoLimit, kNoLimit);
    once("--set-joint", name, arm.joint_values.emplace(name, number).second);
  }
}

}  // namespace

RunText::RunText() {
  named = {{"ants", ""}, {"iterations", ""}, {"neighbours", ""}, {"corners", ""}, {"polish", ""}};
}

ArmText::ArmText() {
  named = {{"ants", ""}, {"iterations", ""}, {"pitch", ""},
           {"side", ""}, {"objective", ""},  {"max_questions", ""}};
}

std::string& SearchText::value_of(std::string_view name) {
  for (auto& [known, value] : named)
    if (known == name) return value;
  throw std::logic_error("no option of this name");
}

std::uint64_t seed_value(const std::string& text) {
  if (text.empty()) return 1;
  return static_cast<std::uint64_t>(integer_value("--seed", text, 0, kMaxExactInteger));
}

std::pair<std::uint64_t, int> seed_range(std::string_view option, const std::string& text,
                                         std::int64_t least) {
  const auto range = parse_range(text);
  if (!range || range->first < least || range->second > kMaxExactInteger ||
      range->second - range->first >= SearchOptions::kMostSeeds)
    throw UsageError(std::string(option) + ": \"" + text +
                     "\" is neither N nor A-B nor A..B, from " + std::to_string(least) +
                     " to 2^53-1 and at most " + std::to_string(SearchOptions::kMostSeeds) +
                     " of them");
  return {static_cast<std::uint64_t>(range->first),
          static_cast<int>(range->second - range->first) + 1};
}

void check_endings(const std::vector<std::string>& files,
                   std::span<const std::string_view> endings) {
  for (const auto& file : files) {
    if (std::ranges::any_of(endings, [&](auto ending) { return has_ending(file, ending); }) ||
        is_stream(file))
      continue;
    const auto dot = file.find_last_of("./");
    const bool dotted = dot != std::string::npos && file[dot] == '.';
    choice_value("-o " + file, dotted ? file.substr(dot) : "", endings);
  }
}

RunOptions make_run(const RunText& text, std::span<const std::string_view> endings) {
  RunOptions run;
  read_search(text, run, endings);
  run.params = make_params<Params>(run, bitmaps());
  const bool certifies = !moves_on_cells(run.params);
  run.frame = frame_of(text.frame);
  MapOptions& map = run.map;
  map.file = text.map;
  run.inputs = {map.file, run.preset_file};
  take_real("--radius", text.radius, 0, kNoLimit, map.radius);
  take_real("--goal-tolerance", text.goal_tolerance, 0, kNoLimit, run.goal_tolerance);
  map.radius_metres = run.frame == Frame::world;
  map.unknown_is_free = text.unknown_free;
  if (text.unknown_free && !is_document(map.file))
    run.notes.push_back("--unknown-free has no effect: only ROS maps (.yaml) have unknown cells");
  if (run.target_gap > 0 && !certifies)
    run.notes.push_back("--target-gap has no effect: " + run.params.algorithm() +
                        " certifies no gap");
  run.with_optimum = text.gap;
  map.prepare = text.prepare && (run.with_optimum || certifies);
  map.threads = run.threads;
  if (text.prepare && !map.prepare)
    run.notes.push_back("--prepare has no effect: it is for exact, and for --gap");
  const bool ants = find_algorithm(run.params.algorithm()).kind == Algorithm::Kind::colony;
  if (!text.tracks.empty() && !ants)
    run.notes.push_back("--tracks has no effect: " + run.params.algorithm() + " has no ants");
  else if (!text.tracks.empty() && std::ranges::none_of(run.outputs, is_picture))
    run.notes.push_back("--tracks has no effect without -o of a picture, .svg or .png");
  if (!text.tracks.empty()) run.track_iterations = list_value("--tracks", text.tracks);
  return run;
}

Frame frame_of(const std::string& text) {
  return text.empty() ? Frame::cell : static_cast<Frame>(choice_value("--frame", text, kFrames));
}

Point end_value(std::string_view option, const std::string& text, Frame frame,
                const std::string& map) {
  if (frame == Frame::world) return pair_value(option, text, false);
  try {
    return pair_value(option, text, true);
  } catch (const UsageError& error) {
    if (!is_document(map)) throw;
    (void)pair_value(option, text, false);
    throw UsageError(std::string(error.what()) +
                     "; for metres of the map's frame add --frame world");
  }
}

PlanCommand make_plan(const EndsText& ends, RunOptions run) {
  if (ends.start.empty()) throw UsageError("--start is required; see --help");
  if (ends.goal.empty()) throw UsageError("--goal is required; see --help");
  const Point start = end_value("--start", ends.start, run.frame, run.map.file);
  const Point goal = end_value("--goal", ends.goal, run.frame, run.map.file);
  return {std::move(run), start, goal};
}

DriveCommand make_drive(const DriveText& text) {
  if (is_world(text.map)) throw UsageError(text.map + ": drives are on bitmaps only");
  if (!text.tracks.empty())
    throw UsageError("--tracks: a drive's picture shows the robot's track; leave it out");
  DriveCommand drive{make_plan(text.ends, make_run(text, kDriveEndings))};
  RunOptions& run = drive.run;
  if (run.ranged)
    throw UsageError("--seed " + text.seed + ": one drive has one seed; a range is for plan");
  if (run.with_optimum)
    run.notes.emplace_back("--gap has no effect: a drive always tells the optimum of its moves");
  run.map.prepare = text.prepare && !moves_on_cells(run.params);
  drive.world = text.world;
  drive.changes = text.changes;
  run.inputs.insert(run.inputs.end(), {drive.world, drive.changes});
  take_real("--sense", text.sense, run.map.radius_metres ? 0 : DriveCommand::kLeastSense,
            DriveCommand::kMostSense, drive.sense);
  if (!text.max_ticks.empty())
    drive.max_ticks = integer_value("--max-ticks", text.max_ticks, 0, DriveCommand::kMostTicks);
  return drive;
}

ArmCommand make_arm(const ArmText& text) {
  ArmCommand arm = text.taken;
  read_search(text, arm, kArmEndings);
  if (arm.ranged)
    throw UsageError("--seed " + text.seed +
                     ": arm takes one seed; several are for plan and batch");
  if (text.plain) arm.named.insert(arm.named.end(), {{"shortcut", "off"}, {"shortcuts", "0"}});
  read_robot_options(text, arm);
  if (is_numeric(text.start))
    arm.start = reals_value("--start", text.start, 1, 16);
  else
    arm.start_state = text.start;
  for (const auto& [option, value] : text.goals) arm.goals.push_back(arm_goal(option, value));
  arm.inputs = {arm.robot, arm.scene, arm.srdf, arm.joint_limits};
  if (arm.goals.empty())
    throw UsageError("a goal is required: --goal, --goal-pose, --goal-joints or --goal-state");
  const auto tolerance = [](const char* option, const std::string& value, double& to) {
    take_real(option, value, ArmCommand::kLeastTolerance, ArmCommand::kMostTolerance, to);
  };
  tolerance("--position-tolerance", text.position_tolerance, arm.position_tolerance);
  tolerance("--angle-tolerance", text.angle_tolerance, arm.angle_tolerance);
  if (std::ranges::find(arm.goals, ArmGoal::Kind::pose, &ArmGoal::kind) == arm.goals.end()) {
    for (const auto& [option, value] : {std::pair{"--position-tolerance", text.position_tolerance},
                                        {"--angle-tolerance", text.angle_tolerance}})
      if (!value.empty())
        arm.notes.push_back(std::string(option) + " has no effect without --goal-pose");
  }
  take_real("--clearance", text.clearance, ArmCommand::kLeastClearance, ArmCommand::kMostClearance,
            arm.clearance);
  take_real("--duration", text.duration, ArmCommand::kLeastDuration, ArmCommand::kMostDuration,
            arm.duration);
  take_real("--rate", text.rate, ArmCommand::kLeastRate, ArmCommand::kMostRate, arm.rate);
  if (!text.recheck.empty())
    arm.recheck =
        static_cast<int>(integer_value("--recheck", text.recheck, 1, ArmCommand::kMostRecheck));
  return arm;
}

WorldOptions make_world_options(const std::string& file, const WorldText& text) {
  WorldOptions options{.file = file, .repair = text.repair, .margin = {}};
  take_real("--margin", text.margin, 0, WorldOptions::kMostMargin, options.margin);
  if (!text.join.empty())
    options.join = static_cast<int>(choice_value("--join", text.join, kJoins));
  if (!text.boundary.empty())
    options.boundary = static_cast<int>(choice_value("--boundary", text.boundary, kBoundaries));
  return options;
}

PolygonCommand make_polygon(const RunText& run, const PolygonText& text,
                            std::span<const std::string_view> endings) {
  PolygonCommand command;
  read_search(run, command, endings);
  command.world = make_world_options(run.map, text.world);
  command.inputs = {run.map};
  command.start = optional_point("--start", text.ends.start);
  command.goal = optional_point("--goal", text.ends.goal);
  command.with_optimum = true;  // it is found beside
  if (!run.frame.empty()) {
    if (kFrames[choice_value("--frame", run.frame, kFrames)] == "world")
      throw UsageError("--frame world: " + run.map +
                       " gives no frame, a polygon world is in its own coordinates; leave it out");
    command.notes.emplace_back("--frame has no effect on a polygon world");
  }
  refuse_radius(run.radius);
  take_real("--goal-tolerance", run.goal_tolerance, 0, kNoLimit, command.goal_tolerance);
  if (run.unknown_free)
    command.notes.emplace_back("--unknown-free has no effect: a polygon world has no unknown part");
  if (run.prepare) command.notes.emplace_back("--prepare has no effect on a polygon world");
  if (!run.tracks.empty()) {
    list_value("--tracks", run.tracks);
    command.notes.emplace_back("--tracks has no effect on a polygon world");
  }
  return command;
}

void refuse_radius(std::string_view radius) {
  if (!radius.empty()) throw UsageError("--radius: obstacles of a polygon world grow by --margin");
}

void refuse_world_options(const WorldText& text) {
  const char* option = !text.margin.empty()     ? "--margin"
                       : !text.join.empty()     ? "--join"
                       : !text.boundary.empty() ? "--boundary"
                       : text.repair            ? "--repair"
                                                : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) +
                     " is for polygon worlds (.geojson, .json, .wkt); obstacles of a bitmap grow "
                     "by --radius");
}

}  // namespace lasius::tool
