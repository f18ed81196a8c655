#include "tools/command_line/polygon_text.h"

#include <algorithm>
#include <array>

#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

std::optional<Point> point(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return pair_value(option, text, false);
}

}  // namespace

bool is_world(std::string_view file) {
  return std::ranges::any_of(std::array{".geojson", ".json", ".wkt"},
                             [&](std::string_view ending) { return has_ending(file, ending); });
}

WorldOptions make_world_options(const std::string& file, const WorldText& text) {
  WorldOptions options{.file = file, .repair = text.repair, .margin = {}};
  if (!text.margin.empty())
    options.margin = real_value("--margin", text.margin, 0, WorldOptions::kMostMargin);
  if (!text.join.empty())
    options.join = static_cast<int>(choice_value("--join", text.join, kJoins));
  return options;
}

void refuse_radius(std::string_view radius) {
  if (!radius.empty()) throw UsageError("--radius: obstacles of a polygon world grow by --margin");
}

PolygonCommand make_polygon(const RunText& run, const PolygonText& text) {
  PolygonCommand command{.world = make_world_options(run.map, text.world),
                         .start = point("--start", text.start),
                         .goal = point("--goal", text.goal),
                         .algorithm = run.algorithm,
                         .named = {},
                         .settings = run.set,
                         .threads = thread_count(run.threads),
                         .time_limit = {},
                         .with_optimum = run.gap,
                         .json = run.json,
                         .outputs = run.outputs,
                         .messages = make_messages(run),
                         .notes = {}};
  for (const auto& [name, value] : run.named)
    if (!value.empty()) command.named.emplace_back(name, value);
  command.seed = seed_value(run.seed);
  command.time_limit = time_limit_value(run.time_limit);
  command.target_gap = target_gap_value(run.target_gap);
  if (!run.frame.empty()) choice_value("--frame", run.frame, kFrames);
  refuse_radius(run.radius);
  if (run.unknown_free)
    command.notes.emplace_back("--unknown-free has no effect: a polygon world has no unknown part");
  if (run.prepare) command.notes.emplace_back("--prepare has no effect on a polygon world");
  if (!run.tracks.empty()) {
    list_value("--tracks", run.tracks);
    command.notes.emplace_back("--tracks has no effect on a polygon world");
  }
  check_endings(run.outputs, kOutputEndings);
  return command;
}

void refuse_world_options(const WorldText& text) {
  const char* option = !text.margin.empty() ? "--margin"
                       : !text.join.empty() ? "--join"
                       : text.repair        ? "--repair"
                                            : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) +
                     " is for polygon worlds (.geojson, .json, .wkt); obstacles of a bitmap grow "
                     "by --radius");
}

}  // namespace lasius::tool
