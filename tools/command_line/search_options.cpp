#include "tools/command_line/search_options.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/number_text.h"
#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/parameters.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"
#include "tools/yaml/document.h"
#include "tools/yaml/preset_file.h"

namespace lasius::tool {
namespace {

constexpr std::array<std::string_view, 3> kModes{"auto", "always", "never"};

/// "N", or "A-B" or "A..B": seeds from A to B.
void read_seeds(const std::string& text, SearchOptions& options) {
  options.ranged = text.find("..") != std::string::npos || text.find('-', 1) != std::string::npos;
  if (options.ranged)
    std::tie(options.seed, options.seeds) = seed_range("--seed", text, 0);
  else
    options.seed = static_cast<std::uint64_t>(integer_value("--seed", text, 0, kMaxExactInteger));
}

/// The numbers of a preset's file, and its algorithm where none is named.
void take_preset(SearchOptions& options) {
  PresetFile preset = read_preset_file(options.preset_file);
  if (options.algorithm.empty()) options.algorithm = preset.algorithm;
  if (options.algorithm != preset.algorithm)
    throw UsageError("--preset " + options.preset_file + " is of " + preset.algorithm +
                     ", not of " + options.algorithm + "; leave --algorithm out");
  options.preset = preset.preset;
  options.preset_settings = std::move(preset.settings);
}

}  // namespace

void add_parameter(OptionTable& table, const char* option, SearchOptions& to, const char* help,
                   const char* type) {
  std::string name(option + 2);
  std::ranges::replace(name, '-', '_');
  table.add(option, help, type,
            [name, &to](const auto& text) { to.named.emplace_back(name, text); });
}

void add_preset(OptionTable& table, SearchOptions& to, const char* help) {
  const auto read = [&to](const std::string& text) {
    if (is_document(text))
      to.preset_file = text;
    else
      to.preset = static_cast<Preset>(choice_value("--preset", text, kPresetNames));
  };
  table.shell(table.add("--preset", help, "usual|book|FILE", read),
              {.choices = texts(kPresetNames), .files = true, .endings = kDocuments});
}

void add_search_options(OptionTable& table, SearchOptions& to, const SearchHelp& help) {
  using enum Values::Names;
  table.shell(table.text("--algorithm", to.algorithm, "Algorithm, as listed by `lasius algorithms`",
                         "NAME"),
              {.names = algorithms});
  table.shell(
      table.repeatable("--set", to.settings,
                       "Set any parameter of the algorithm (repeatable; wins over its own option)",
                       "NAME=VALUE"),
      {.names = parameters});
  add_parameter(table, "--ants", to, "Ants an iteration", "N");
  add_parameter(table, "--iterations", to, "Iterations", "N");
  table.add("--seed", help.seed, "N", [&to](const auto& text) { read_seeds(text, to); });
  to.threads = 0;
  table.add("--threads",
            "Threads (default LASIUS_THREADS, OMP_NUM_THREADS, all cores); never changes a result",
            "N", [&to](const auto& text) { to.threads = thread_count(text); });
  table.real("--time-limit", to.time_limit, 0, kNoLimit, help.time_limit, "SECONDS");
  table.add("--target-gap", help.target_gap, "PCT", [&to](const auto& text) {
    to.target_gap = real_value("--target-gap", text, 0, kNoLimit) / 100;
  });
  table.flag("--json", to.json, help.json);
  const auto output = [&to, endings = help.endings](const std::string& file) {
    check_ending(file, endings);
    to.outputs.push_back(file);
  };
  table.shell(table.repeatable("-o,--output", help.outputs, "FILE", output),
              {.files = true, .endings = texts(help.endings)});
  table.choice("--progress", to.messages.progress, kModes, "Progress on stderr",
               "auto|always|never");
  table.flag("-q,--quiet", to.messages.quiet, "Print errors only");
  table.flag("-v,--verbose", to.messages.verbose, "Print what is done");
}

void finish_search(SearchOptions& options) {
  if (!options.preset_file.empty()) take_preset(options);
  refuse_repeats(options.settings);
  if (options.threads == 0) options.threads = thread_count("");
  const auto page = std::ranges::find_if(options.outputs, is_page);
  if (options.ranged && page != options.outputs.end())
    throw UsageError("-o " + *page + ": a report plays one run; give it one seed");
  const auto poses = std::ranges::find_if(options.outputs, is_yaml);
  if (options.ranged && poses != options.outputs.end())
    throw UsageError("-o " + *poses + ": it holds the poses of one run; give it one seed");
  if (options.messages.quiet && options.messages.verbose)
    throw UsageError("-q and -v exclude each other");
}

void add_seed(OptionTable& table, std::uint64_t& to) {
  table.integer("--seed", to, 0, kMaxExactInteger, "Seed, from 0 to 2^53-1 (default 1)", "N");
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

void add_part(OptionTable& table, Part& to, const char* help) {
  table.add("--part", help, "I/N", [&to](const std::string& text) {
    const auto numbers = split(text, '/');
    const auto number = number_of<int>(numbers.front());
    const auto of = number_of<int>(numbers.back());
    if (numbers.size() != 2 || !number || !of || *of < 1 || *of > Part::kMost || *number < 1 ||
        *number > *of)
      throw UsageError("--part: \"" + text + "\" is not I/N, with N from 1 to " +
                       std::to_string(Part::kMost) + " and I from 1 to N");
    to = {.number = *number, .of = *of};
  });
}

void check_ending(const std::string& file, std::span<const std::string_view> endings) {
  if (is_proof(file) && std::ranges::count(endings, ".proof.cbor") == 0)
    throw UsageError("-o " + file +
                     ": a proof is of one plan over costs; name another file, or ask plan --cost");
  if (is_stream(file) ||
      std::ranges::any_of(endings, [&](auto ending) { return has_ending(file, ending); }))
    return;
  const auto dot = file.find_last_of("./");
  const bool dotted = dot != std::string::npos && file[dot] == '.';
  choice_value("-o " + file, dotted ? file.substr(dot) : "", endings);
}

std::vector<std::string> texts(std::span<const std::string_view> words) {
  return {words.begin(), words.end()};
}

End point_value(std::string_view option, const std::string& text, Frame frame) {
  const bool point = frame == Frame::world || is_point(text);
  try {
    return {pair_value(option, text, !point), point};
  } catch (const UsageError& error) {
    if (point) throw;
    throw UsageError(std::string(error.what()) + " or a point, as in 12.5,3.25");
  }
}

double angle_value(std::string_view option, std::string_view text, double low, double high) {
  const bool degrees = text.ends_with("deg");
  const auto value = parse_real(text.substr(0, text.size() - (degrees ? 3 : 0)));
  const double angle = !value ? 0 : degrees ? *value / 180 * std::numbers::pi : *value;
  if (value && angle >= low && angle <= high) return angle;
  const bool limited = high < kNoLimit;
  throw UsageError(std::string(option) + ": \"" + std::string(text) + "\" is no angle" +
                   (limited ? " from " + to_text(low) + " to " + to_text(high) + " radians" : "") +
                   "; write 1.57, or in degrees 90deg");
}

std::string turns_hint(std::string_view text, double yaw) {
  const double turns = std::abs(yaw) / (2 * std::numbers::pi);
  if (turns <= 1 || text.ends_with("deg")) return {};
  return printed(": %g radians are %.2f turns; degrees end in deg", yaw, turns);
}

PoseEnd pose_value(std::string_view option, const std::string& text, RunOptions& run) {
  constexpr double kMostTurned = 1e5;
  const auto comma = text.find_last_of(',');
  if (comma == text.npos || text.find(',') == comma)
    throw UsageError(std::string(option) + ": \"" + text +
                     "\" is not X,Y,YAW; of a vehicle also say where it looks, in radians, as "
                     "1.57, or in degrees, as 90deg");
  const std::string_view angle = std::string_view(text).substr(comma + 1);
  const double yaw = angle_value(option, angle, -kMostTurned, kMostTurned);
  if (const std::string hint = turns_hint(angle, yaw); !hint.empty())
    run.notes.push_back(std::string(option) + hint);
  return {point_value(option, text.substr(0, comma), run.frame), yaw};
}

Point end_value(std::string_view option, const std::string& text, Frame frame) {
  const End end = point_value(option, text, frame);
  return frame == Frame::world ? Point(end) : Point{std::floor(end.x), std::floor(end.y)};
}

void require(const std::string& command, const char* option, const std::string& text) {
  if (text.empty()) throw UsageError(command + option + " is required; see --help");
}

std::vector<std::string> map_endings(bool with_worlds) {
  std::vector<std::string> all{".map", ".pbm", ".pgm", ".png", ".yaml", ".yml"};
  if (with_worlds) all.insert(all.end(), kPolygonFileEndings.begin(), kPolygonFileEndings.end());
  return all;
}

}  // namespace lasius::tool
