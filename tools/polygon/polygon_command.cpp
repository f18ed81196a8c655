#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/bitmap/answer.h"
#include "tools/commands.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/polygon/polygon_report.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

void announce(const PreparedWorld& world, const PolygonCommand& command,
              const polygon::Params& parameters, const std::vector<std::string>& notes) {
  if (command.messages.quiet) return;
  for (const auto& note : command.notes) message(note);
  for (const auto& note : notes) message(note);
  if (!command.messages.verbose) return;
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(),
                ": %zu obstacles, %zu lines, %zu regions, hash %s, read in %.1f ms, prepared in "
                "%.1f ms",
                world.planner.world().obstacles.size(), world.planner.maklink().lines.size(),
                world.planner.maklink().regions.size(), hash_text(world.hash).c_str(),
                world.read_ms, world.prepare_ms);
  message(world.file + text.data());
  message(parameters.algorithm() + ", seed " + std::to_string(parameters.seed));
}

bool iterates(std::string_view algorithm) {
  return polygon::find_algorithm(algorithm).has("iterations");
}

PolygonAnswer watched_answer(const PreparedWorld& world, const PolygonCommand& command,
                             const polygon::Params& parameters, const std::stop_token& token) {
  const bool shown = wants_progress(command.messages);
  ProgressLine bar(shown,
                   iterates(parameters.algorithm())
                       ? std::int64_t{parameters.iterations} * parameters.routes
                       : 0,
                   command.time_limit.value_or(0));
  polygon::Observer observer;
  if (shown)
    observer = [&](const Progress& view) {
      std::array<char, 48> text;
      std::snprintf(text.data(), text.size(), "best %.3f", view.best_length);
      bar.update(view.iteration + 1, text.data());
    };
  const StopCondition stop{.token = token, .deadline = deadline_after(command.time_limit)};
  return polygon_answer(world, command, parameters, stop, observer);
}

}  // namespace

int run_polygon(const PolygonCommand& command) {
  std::vector<std::string> notes;
  const auto parameters = polygon_parameters(command, notes);
  for (const auto& file : command.outputs) check_writable(file);
  const PreparedWorld world = prepare_world(command.world);  // a signal ends it at once
  SignalWatcher signals;
  if (!command.start && !world.planner.world().start)
    throw UsageError("--start is required: " + world.file + " has no feature with the role start");
  if (!command.goal && !world.planner.world().goal)
    throw UsageError("--goal is required: " + world.file + " has no feature with the role goal");
  announce(world, command, parameters, notes);
  const PolygonAnswer answer = watched_answer(world, command, parameters, signals.token());

  const polygon::Result& result = answer.result;
  const bool counts = iterates(answer.parameters.algorithm());
  const Outcome ended{.status = result.status,
                      .iterations = counts ? std::optional(result.iterations) : std::nullopt,
                      .has_path = !result.path.empty(),
                      .error = result.error};
  report(ended, command.messages);
  const Forms forms{
      .text = [&] { return polygon_text(answer); },
      .json = [&] { return line(polygon_json(world, command, answer)); },
      .csv = [&] { return result_csv(result, result.path, counts, Frame::cell); },
      .write_picture =
          [&](const std::string& file) { write_polygon_picture(file, world, answer); }};
  deliver(forms, command.json, command.outputs, command.messages);
  return signals.interrupted() ? kInterrupted : exit_code(ended);  // --gap may be what was cut off
}

}  // namespace lasius::tool
