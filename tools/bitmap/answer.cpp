#include "tools/bitmap/answer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "lasius/shortest_walk.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// Why a start or goal is invalid, with its place as it was given, and in metres too the free cell
/// that is nearest.
std::string invalid_text(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  const bool at_start =
      result.fault == Fault::start_blocked || result.fault == Fault::start_outside;
  const bool outside = result.fault == Fault::start_outside || result.fault == Fault::goal_outside;
  const Place& place = at_start ? answer.start : answer.goal;
  const auto [x, y] = place.number;
  const std::string named = "(" + whole_text(x) + ", " + whole_text(y) + ")";
  std::string text = at_start ? "start " : "goal ";
  if (run.frame == Frame::world) {
    text += to_text(place.asked.x) + "," + to_text(place.asked.y) + " m, in cell " + named + ",";
  } else {
    text += named;
  }
  text += outside ? " is outside the map" : " is blocked";
  const auto& free = result.nearest_free;
  if (!free) return map.grid().count_free() == 0 ? text + "; the map has no free cell" : text;
  text += "; the nearest free cell is (" + std::to_string(free->x) + ", " +
          std::to_string(free->y) + ")";
  if (run.frame == Frame::cell) return text;
  const Point metres = map.to_world(centre(*free));
  std::array<char, 96> centre_text;
  std::snprintf(centre_text.data(), centre_text.size(), ", its centre at %.3f,%.3f m", metres.x,
                metres.y);
  return text + centre_text.data();
}

/// Adds what --gap asks for. Each search has the time that the plan had, from its own start.
void add_optima(const PreparedMap& map, const RunOptions& run, const StopCondition& stop,
                Answer& answer) {
  const Request query{answer.start.cell, answer.goal.cell};
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
  const Request request{.start = start.cell,
                        .goal = goal.cell,
                        .stop = stop,
                        .target_gap = moves_on_cells(run) ? 0 : run.target_gap};
  Workspace workspace;  // to give back a large one takes time, which is not the plan's
  const auto begin = Clock::now();
  answer.result = map.planner->plan(request, run.params, &workspace, observer);
  answer.elapsed_ms = ms_since(begin);
  if (run.with_optimum) add_optima(map, run, stop, answer);
  return answer;
}

bool moves_on_cells(const RunOptions& run) {
  return find_algorithm(run.params.algorithm()).kind != Algorithm::Kind::exact;
}

void set_optima(const RunOptions& run, std::optional<double> any_angle,
                std::optional<double> by_moves, Answer& answer) {
  // Cell by cell, Corners::allow squeezes through where no path of the plane may.
  const bool squeezes = moves_on_cells(run) && run.params.corners == Corners::allow &&
                        run.params.neighbours != Neighbours::four;
  if (!squeezes) answer.optimum = any_angle;
  answer.grid_optimum = moves_on_cells(run) ? by_moves : answer.optimum;
}

std::optional<double> shortest_by_own_moves(const PreparedMap& map, const RunOptions& run,
                                            const Request& query, const StopCondition& stop) {
  const Grid& grid = map.grid();
  const bool joined = grid.free(query.start) && grid.free(query.goal) &&
                      map.planner->connected(query.start, query.goal, run.params.corners);
  if (!joined) return std::nullopt;
  return shortest_walk(grid, query.start, query.goal, run.params.neighbours, run.params.corners,
                       stop);
}

Params optimum_params(const RunOptions& run) {
  Params params;
  params.threads = run.params.threads;
  return params;
}

Outcome outcome(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  std::string error =
      result.status == Status::invalid ? invalid_text(map, run, answer) : result.error;
  if (result.status == Status::invalid || result.status == Status::unreachable) error += grown(map);
  const bool iterates = find_algorithm(run.params.algorithm()).has("iterations");
  return {.status = result.status,
          .iterations = iterates ? std::optional(result.iterations) : std::nullopt,
          .has_path = !result.path.empty(),
          .error = std::move(error)};
}

}  // namespace lasius::tool
