#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/output.h"
#include "lasius/batch.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_task.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/picture.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/signals.h"
#include "tools/console/team.h"
#include "tools/options/commands.h"
#include "tools/record/batch_output.h"
#include "tools/record/queries.h"

namespace lasius::tool {
namespace {

/// What --gap adds to some queries.
struct Optima {
  std::vector<std::optional<double>> any_angle, by_moves;
};

Optima optima(const LoadedMap& map, const RunOptions& run, std::span<const Request> queries,
              BatchOptions options) {
  options.seeds = 1;
  Optima found;
  found.any_angle.resize(queries.size());
  std::vector<Request> exact(queries.begin(), queries.end());
  for (Request& query : exact) query.target_gap = 0;
  plan_batch(*map.planner, exact, optimum_params(run), options, [&](const BatchAnswer& answer) {
    if (answer.result.optimal) found.any_angle[answer.index] = answer.result.length;
  });
  found.by_moves.resize(queries.size());
  if (!moves_on_cells(run.params)) return found;
  const auto ask = [&](std::size_t i) {
    const StopCondition stop{.token = options.token, .deadline = deadline_after(run.time_limit)};
    found.by_moves[i] = shortest_by_own_moves(map, run, queries[i], stop);
  };
  share_out(queries.size(), options.threads, [&] { return ask; });
  return found;
}

/// The command's queries: a file's, or its own one.
QueryFile queries_of(const BatchCommand& command, const LoadedMap& map) {
  if (command.queries.empty()) return {.queries = {{command.start, command.goal}}};
  return read_queries(command.queries, map.width, map.height, command.run.frame == Frame::cell);
}

/// Start and goal of a line.
std::pair<Place, Place> ends_of(const QueryFile& file, std::size_t line, const LoadedMap& map,
                                Frame frame) {
  const auto [start, goal] = file.queries[line];
  const auto place = file.scenario ? place_of : to_place;
  return {place(map, start, frame), place(map, goal, frame)};
}

std::vector<Request> requests_of(const QueryFile& file, const LoadedMap& map,
                                 const RunOptions& run) {
  std::vector<Request> requests;
  for (std::size_t i = 0; i < file.queries.size(); ++i) {
    const auto [start, goal] = ends_of(file, i, map, run.frame);
    requests.push_back({.start = start.cell,
                        .goal = goal.cell,
                        .target_gap = moves_on_cells(run.params) ? 0 : run.target_gap});
  }
  return requests;
}

}  // namespace

int run_command(const BatchCommand& command) {
  const RunOptions& run = command.run;
  check_outputs(run.outputs, {run.map.file, command.queries});
  SignalWatcher signals;
  const auto shared = std::make_shared<LoadedMap>(
      load_map(run.map, run.frame, run.params.corners, signals.token()));
  const LoadedMap& map = *shared;
  check_outputs(run.outputs, {map.image});
  const QueryFile file = queries_of(command, map);
  BitmapTask task({.run = run, .start = {}, .goal = {}}, shared);
  if (!run.messages.quiet) task.announce();
  const std::vector<Request> queries = requests_of(file, map, run);

  BatchOptions options{.threads = run.params.threads, .token = signals.token(), .seeds = run.seeds};
  if (run.time_limit) options.time_limit = std::chrono::duration<double>(*run.time_limit);
  BatchOutput output(task, static_cast<std::int64_t>(queries.size()) * run.seeds);
  // The optimum is asked beside each chunk, so that answers still stream.
  const std::size_t chunk = run.with_optimum ? 256 : queries.size();
  for (std::size_t from = 0; from < queries.size() && !signals.interrupted(); from += chunk) {
    const auto part = std::span(queries).subspan(from, std::min(chunk, queries.size() - from));
    Optima best;
    if (run.with_optimum) best = optima(map, run, part, options);
    plan_batch(*map.planner, part, run.params, options, [&](const BatchAnswer& found) {
      const std::size_t index = from + found.index;
      const auto [start, goal] = ends_of(file, index, map, run.frame);
      Answer answer{.start = start,
                    .goal = goal,
                    .result = found.result,
                    .elapsed_ms = std::chrono::duration<double, std::milli>(found.elapsed).count(),
                    .index = index};
      if (run.with_optimum)
        set_optima(run, best.any_angle[found.index], best.by_moves[found.index], answer);
      task.set_seed(found.seed);
      task.take(std::move(answer));
      output.add(task, task.end_texts(), task.result().path);
    });
  }
  output.write_files([&](const std::string& picture, const auto& paths) {
    write_batch_picture(picture, map, run, paths);
  });
  return signals.interrupted() ? kInterrupted : kFound;
}

}  // namespace lasius::tool
