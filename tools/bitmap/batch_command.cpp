#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/loop/batch_run.h"
#include "lasius/plan/batch.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/picture.h"
#include "tools/bitmap/reasons.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/signals.h"
#include "tools/console/values.h"
#include "tools/record/batch.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"

namespace lasius::tool {
namespace {

/// The length of each query's shortest path, where `exact` proves one in time.
std::vector<std::optional<double>> optima(const LoadedMap& map, const RunOptions& run,
                                          std::span<const Request> queries, BatchOptions how) {
  how.seeds = 1;
  std::vector<Request> requests(queries.begin(), queries.end());
  for (Request& request : requests) request.target_gap = 0;
  std::vector<std::optional<double>> found(queries.size());
  plan_batch(*map.planner, requests, optimum_params(run), how, [&](const BatchAnswer& answer) {
    if (answer.result.optimal) found[answer.index] = answer.result.length;
  });
  return found;
}

/// Of each query the length of the shortest walk by the algorithm's own moves, as far as it is
/// known; none of `exact`.
std::vector<std::optional<double>> own_optima(const LoadedMap& map, const RunOptions& run,
                                              std::span<const Request> queries,
                                              const std::stop_token& token) {
  std::vector<std::optional<double>> found(queries.size());
  if (!moves_on_cells(run.params) || !run.via.empty()) return found;
  parallel_for(static_cast<int>(queries.size()), run.threads, [&](int number, int) {
    const auto i = static_cast<std::size_t>(number);
    const StopCondition stop{.token = token, .deadline = deadline_after(run.time_limit)};
    found[i] = shortest_by_own_moves(map, run, queries[i], stop);
  });
  return found;
}

/// The command's queries: a file's, or its own one.
QueryFile queries_of(const PlanCommand& command, const LoadedMap& map) {
  if (command.queries.empty()) return {.queries = {{command.start, command.goal}}};
  const bool cells = command.run.frame == Frame::cell;
  return read_queries(command.queries, map.width, map.height, cells, cells && map.frame);
}

/// Start and goal of a line.
std::pair<Place, Place> ends_of(const QueryFile& file, std::size_t line, const LoadedMap& map,
                                Frame frame) {
  const auto [start, goal] = file.queries[line];
  const auto place = [&](const End& end) {
    return file.scenario ? place_of(map, end, frame) : end_place(map, end, frame);
  };
  return {place(start), place(goal)};
}

std::vector<Request> requests_of(const QueryFile& file, const LoadedMap& map,
                                 const RunOptions& run) {
  std::vector<Request> requests;
  for (std::size_t i = 0; i < file.queries.size(); ++i) {
    const auto [start, goal] = ends_of(file, i, map, run.frame);
    requests.push_back(request_of(map, run, start, goal));
  }
  return requests;
}

void plan_over_costs(const LoadedMap& map, const RunOptions& run, std::span<const Request> queries,
                     std::uint64_t first_seed, const BatchOptions& how,
                     const BatchReceiverOf<CostResult>& receive) {
  run_batch<CostResult>(queries, first_seed, how, receive, [&] {
    return [&, options = cost_options(run)](const Request& request, std::uint64_t seed) mutable {
      options.params.seed = seed;
      options.params.threads = 1;
      return map.costs->planner->plan(request, options);
    };
  });
}

Params seeded(Params params, std::uint64_t seed) {
  params.seed = seed;
  return params;
}

/// Start and goal as they were asked for, a coordinate a text.
std::vector<std::string> end_texts(const RunOptions& run, const Answer& answer) {
  std::vector<std::string> texts;
  for (const Place* place : {&answer.start, &answer.goal}) {
    const auto text = run.frame == Frame::world || place->point ? to_text : whole_text;
    texts.insert(texts.end(), {text(place->asked.x), text(place->asked.y)});
  }
  return texts;
}

/// What answers may be compared with, of each query of a part.
struct Optima {
  std::vector<std::optional<double>> any_angle, by_moves;
  std::vector<CostResult> least;  // over costs

  Optima(const LoadedMap& map, const RunOptions& run, std::span<const Request> part,
         const BatchOptions& how) {
    if (!run.with_optimum) return;
    if (!map.costs) {
      any_angle = optima(map, run, part, how);
      by_moves = own_optima(map, run, part, how.token);
      return;
    }
    least.resize(part.size());
    parallel_for(static_cast<int>(part.size()), run.threads, [&](int number, int) {
      const auto i = static_cast<std::size_t>(number);
      least[i] = least_cost(map, run, part[i],
                            {.token = how.token, .deadline = deadline_after(run.time_limit)});
    });
  }

  void set(const RunOptions& run, std::size_t query, Answer& answer) const {
    if (!least.empty())
      set_least_cost(answer, least[query]);
    else if (run.with_optimum)
      set_optima(run, any_angle[query], by_moves[query], answer);
  }
};

}  // namespace

int run_bitmap_batch(const PlanCommand& command) {
  RunOptions run = command.run;
  check_files(run);
  SignalWatcher signals;
  Delivery delivery(run.outputs);
  LoadedMap map = load_map(run.map, run.frame, run.params.corners, run.threads, signals.token());
  note_files(map, run);
  check_files(run);
  check_radius(map, run);
  QueryFile file = queries_of(command, map);
  note_yaws(file.yaws, command.queries, run);
  keep_part(file.queries, command.queries, run.part);
  note_map(map, run, signals.token());
  if (auto hint = radius_hint(map, run.frame); !hint.empty()) run.notes.push_back(std::move(hint));
  const std::vector<Request> queries = requests_of(file, map, run);
  const auto answer_part = [&](const Batch::Part& asked, const BatchOptions& how,
                               const Batch::Take& take) {
    const auto part = std::span(queries).subspan(asked.first, asked.count);
    const Optima known(map, run, part, how);
    const auto receive = [&](const auto& found) {
      const std::size_t index = asked.first + found.index;
      const auto [start, goal] = ends_of(file, index, map, run.frame);
      Answer answer{.start = start,
                    .goal = goal,
                    .result = found.result,
                    .elapsed_ms = 1e3 * found.elapsed.count()};
      if constexpr (requires { found.result.cost; }) set_costs(answer, found.result);
      known.set(run, found.index, answer);
      set_remedy(map, run, how.token, answer);
      Record record = record_of(map, run, answer);
      record.index = run.part.among_all(index);
      record.seed = found.seed;
      take(std::move(record), end_texts(run, answer), found.result.path);
    };
    in_metres_asked(map, run, [&] {
      if (map.costs)
        plan_over_costs(map, run, part, asked.seed, how, receive);
      else
        plan_batch(*map.planner, part, seeded(run.params, asked.seed), how, receive);
    });
  };
  // Optima are asked beside each part, so that answers still stream.
  const auto answer_all = [&](const Batch::Part& asked, const BatchOptions& how,
                              const Batch::Take& take) {
    const std::size_t most = run.with_optimum ? 256 : std::max<std::size_t>(asked.count, 1);
    for (std::size_t done = 0; done < asked.count && !how.token.stop_requested(); done += most)
      answer_part({asked.first + done, std::min(most, asked.count - done), asked.seed}, how, take);
  };
  const auto draw = [&](const auto& picture, const auto& paths, const auto& caption) {
    write_batch_picture(picture, map, run, paths, caption);
  };
  const std::string unit = run.frame == Frame::world ? "m" : "";
  return run_batch({.options = run,
                    .unit = unit,
                    .queries = queries.size(),
                    .costs = map.costs.has_value(),
                    .is_plan = command.queries.empty(),
                    .answer = answer_all,
                    .draw = draw},
                   signals, delivery);
}

}  // namespace lasius::tool
