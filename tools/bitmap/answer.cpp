#include "tools/bitmap/answer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "lasius/shortest_walk.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

constexpr std::string_view kExact = "exact";

/// The library's words on a start or goal that is invalid, with its place as it was given, and in
/// metres too the free cell that they name.
std::string invalid_text(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const bool at_start = !map.grid().free(answer.start.cell);
  const Place& place = at_start ? answer.start : answer.goal;
  const std::string& words = answer.result.error;
  const std::string why = words.substr(std::min(words.find(" is "), words.size()));
  const auto [x, y] = place.number;
  std::string named = "(";
  named.append(whole_text(x)).append(", ").append(whole_text(y)).append(")");
  std::string text = at_start ? "start " : "goal ";
  if (run.frame == Frame::cell) return text.append(named).append(why);
  text.append(to_text(place.asked.x)).append(",").append(to_text(place.asked.y));
  text.append(" m, in cell ").append(named).append(",").append(why);
  const auto free = map.planner->nearest_free(place.cell);
  if (!free) return text;
  const Point metres = map.to_world(centre(*free));
  std::array<char, 96> centre_text;
  std::snprintf(centre_text.data(), centre_text.size(), ", its centre at %.3f,%.3f m", metres.x,
                metres.y);
  return text + centre_text.data();
}

/// Adds what --gap asks for. Each search has the time that the plan had, from its own start.
void add_optima(const PreparedMap& map, const RunOptions& run, const StopCondition& stop,
                Answer& answer) {
  const Query query{answer.start.cell, answer.goal.cell};
  const Request exact{
      .start = query.start, .goal = query.goal, .stop = again(stop, run.time_limit)};
  const Result best = map.planner->plan(exact, optimum_params(run));
  set_optima(run, best.optimal ? std::optional(best.length) : std::nullopt,
             moves_on_cells(run)
                 ? shortest_by_own_moves(map, run, query, again(stop, run.time_limit))
                 : std::nullopt,
             answer);
}

/// Says why a cell that looks free is not.
std::string grown(const PreparedMap& map) {
  return map.radius > 0 ? " (obstacles grown by " + to_text(map.radius) + " cells)" : "";
}

}  // namespace

Clock::time_point deadline_after(const std::optional<double>& seconds) {
  return seconds ? deadline_in(std::chrono::duration<double>(*seconds)) : Clock::time_point::max();
}

StopCondition again(const StopCondition& stop, const std::optional<double>& seconds) {
  const bool limited = stop.deadline != Clock::time_point::max();
  return {.token = stop.token, .deadline = deadline_after(limited ? seconds : std::nullopt)};
}

Answer answer(const PreparedMap& map, const RunOptions& run, const Place& start, const Place& goal,
              const StopCondition& stop, const Observer& observer) {
  Answer answer{.start = start, .goal = goal};
  if (!map.planner) {
    answer.result.status = Status::interrupted;
    return answer;
  }
  const Query query{start.cell, goal.cell};
  const Request request{
      .start = query.start, .goal = query.goal, .stop = stop, .target_gap = run.target_gap};
  Workspace workspace;  // to give back a large one takes time, which is not the plan's
  const auto begin = Clock::now();
  answer.result = map.planner->plan(request, run.params, &workspace, observer);
  answer.elapsed_ms = ms_since(begin);
  if (run.with_optimum) add_optima(map, run, stop, answer);
  return answer;
}

bool moves_on_cells(const RunOptions& run) { return run.params.algorithm != kExact; }

void set_optima(const RunOptions& run, std::optional<double> any_angle,
                std::optional<double> by_moves, Answer& answer) {
  // Cell by cell, Corners::allow squeezes through where no path of the plane may.
  const bool squeezes = moves_on_cells(run) && run.params.corners == Corners::allow &&
                        run.params.neighbours != Neighbours::four;
  if (!squeezes) answer.optimum = any_angle;
  answer.grid_optimum = moves_on_cells(run) ? by_moves : answer.optimum;
}

std::optional<double> shortest_by_own_moves(const PreparedMap& map, const RunOptions& run,
                                            const Query& query, const StopCondition& stop) {
  const Grid& grid = map.grid();
  const bool joined = grid.free(query.start) && grid.free(query.goal) &&
                      map.planner->connected(query.start, query.goal, run.params.corners);
  if (!joined) return std::nullopt;
  return shortest_walk(grid, query.start, query.goal, run.params.neighbours, run.params.corners,
                       stop);
}

Params optimum_params(const RunOptions& run) {
  Params params = defaults(kExact);
  params.threads = run.params.threads;
  params.corners = run.params.corners;
  return params;
}

Outcome outcome(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  std::string error =
      result.status == Status::invalid ? invalid_text(map, run, answer) : result.error;
  if (result.status == Status::invalid || result.status == Status::unreachable) error += grown(map);
  const bool iterates = has_parameter(find_algorithm(run.params.algorithm), "iterations");
  return {.status = result.status,
          .iterations = iterates ? std::optional(result.iterations) : std::nullopt,
          .has_path = !result.path.empty(),
          .error = std::move(error)};
}

}  // namespace lasius::tool
