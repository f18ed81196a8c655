#include "answer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "elapsed.h"
#include "lasius/shortest_walk.h"
#include "values.h"

namespace lasius::tool {
namespace {

constexpr std::string_view kExact = "exact";

/// Where the free cell lies that the library named, for those who think in metres.
std::string in_metres(const PreparedMap& map, const Answer& answer) {
  const Cell bad = map.grid().free(answer.start) ? answer.goal : answer.start;
  const auto free = map.planner->nearest_free(bad);
  if (!free) return {};
  const Point metres = map.to_world(centre(*free));
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), ", its centre at %.3f,%.3f m", metres.x, metres.y);
  return text.data();
}

/// Says why a cell that looks free is not.
std::string grown(const PreparedMap& map) {
  return map.radius > 0 ? " (obstacles grown by " + to_text(map.radius) + " cells)" : "";
}

}  // namespace

Clock::time_point deadline_after(const std::optional<double>& seconds) {
  const auto now = Clock::now();
  const auto left = std::chrono::duration<double>(Clock::time_point::max() - now).count();
  if (!seconds || *seconds >= left) return Clock::time_point::max();
  return now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
}

Answer answer(const PreparedMap& map, const RunOptions& run, Cell start, Cell goal,
              const StopCondition& stop, const Observer& observer) {
  Answer answer{.start = start, .goal = goal};
  if (!map.planner) {
    answer.result.status = Status::interrupted;
    return answer;
  }
  const Request request{.start = start, .goal = goal, .stop = stop, .target_gap = run.target_gap};
  const auto begin = Clock::now();
  answer.result = map.planner->plan(request, run.params, nullptr, observer);
  answer.elapsed_ms = ms_since(begin);
  if (run.with_optimum && knows_optimum()) {
    const Request exact{.start = start, .goal = goal, .stop = {.token = stop.token}};
    const Result best = map.planner->plan(exact, optimum_params(run));
    if (best.optimal) answer.optimum = best.length;
    answer.grid_optimum = moves_on_cells(run)
                              ? shortest_by_own_moves(map, run, {start, goal}, stop.token)
                              : answer.optimum;
  }
  return answer;
}

bool moves_on_cells(const RunOptions& run) { return run.params.algorithm != kExact; }

std::optional<double> shortest_by_own_moves(const PreparedMap& map, const RunOptions& run,
                                            const Query& query, const std::stop_token& token) {
  const Grid& grid = map.grid();
  const bool joined = grid.free(query.start) && grid.free(query.goal) &&
                      map.planner->connected(query.start, query.goal, run.params.corners);
  if (!joined) return std::nullopt;
  return shortest_walk(grid, query.start, query.goal, run.params.neighbours, run.params.corners,
                       {.token = token});
}

bool knows_optimum() {
  const auto all = algorithms();
  return std::any_of(all.begin(), all.end(),
                     [](const Algorithm& algorithm) { return algorithm.name == kExact; });
}

Params optimum_params(const RunOptions& run) {
  Params params = defaults(kExact);
  params.threads = run.params.threads;
  params.corners = run.params.corners;
  return params;
}

Outcome outcome(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  std::string error = result.error;
  if (result.status == Status::invalid && run.frame == Frame::world)
    error += in_metres(map, answer);
  if (result.status == Status::invalid || result.status == Status::unreachable) error += grown(map);
  return {.status = result.status,
          .iterations = result.iterations,
          .has_path = !result.path.empty(),
          .error = std::move(error)};
}

}  // namespace lasius::tool
