#include "tools/bitmap/answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lasius/base/error.h"
#include "lasius/path/shortest_walk.h"
#include "tools/console/crew.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/record/batch.h"
#include "tools/record/json_values.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

/// Adds what --gap asks for. Each search has the time that the plan had, from its own start.
void add_optima(const LoadedMap& map, const RunOptions& run, const StopCondition& stop,
                Answer& answer) {
  const Request query{answer.start.cell, answer.result.goal_reached.value_or(answer.goal.cell)};
  Request exact{.start = query.start, .goal = query.goal, .stop = again(stop, run.time_limit)};
  exact.start_point = answer.start.point;
  if (!short_end(answer)) exact.goal_point = answer.goal.point;
  exact.via = request_of(map, run, answer.start, answer.goal).via;
  const Result best = map.planner->plan(exact, optimum_params(run));
  set_optima(run, best.optimal ? std::optional(best.length) : std::nullopt,
             moves_on_cells(run.params) && run.via.empty()
                 ? shortest_by_own_moves(map, run, query, again(stop, run.time_limit))
                 : std::nullopt,
             answer);
}

}  // namespace

void check_radius(const LoadedMap& map, const RunOptions& run) {
  constexpr double kLeast = 0.05, kMost = 54;  // cells, see Planner
  if (run.frame == Frame::cell || !route_of(map, run).curved) return;
  if (map.radius >= kLeast && map.radius <= kMost) return;
  const auto text = [&](double cells) { return rounded_text(map.metres(cells), 6); };
  throw UsageError("--radius is " + text(map.radius) + " m; for exact a disc's radius is between " +
                   text(kLeast) + " and " + text(kMost) +
                   " m (0.05 and 54 cells): coarsen the map or ask a colony for a larger one, plan "
                   "for a point with --radius 0");
}

Point in_metres(const LoadedMap& map, const RunOptions& run, const Answer& answer, Point at) {
  for (const Place* end : {&answer.start, &answer.goal})
    if (run.frame == Frame::world && end->point && at == *end->point) return end->asked;
  return map.to_world(at);
}

std::optional<Point> short_end(const Answer& answer) {
  const auto& path = answer.result.path;
  if (path.empty() || path.back() == answer.goal.at()) return std::nullopt;
  return path.back();
}

bool shares_islands(const RunOptions& run) {
  const auto is_seen = [](const std::string& file) { return is_picture(file) || is_page(file); };
  return crew() != nullptr && run.params.islands > 1 && std::ranges::none_of(run.outputs, is_seen);
}

Request request_of(const LoadedMap& map, const RunOptions& run, const Place& start,
                   const Place& goal) {
  Request request{.start = start.cell,
                  .goal = goal.cell,
                  .target_gap = moves_on_cells(run.params) ? 0 : run.target_gap,
                  .goal_tolerance = map.cells_of(run.map.radius_metres, run.goal_tolerance),
                  .start_point = start.point,
                  .goal_point = goal.point,
                  .alternatives = run.alternatives};
  for (const End& via : run.via) request.via.push_back(end_place(map, via, run.frame).at());
  return request;
}

Answer answer(const LoadedMap& map, const RunOptions& run, const Place& start, const Place& goal,
              const StopCondition& stop, const Observer& observer) {
  Answer answer{.start = start, .goal = goal};
  if (!map.planner) {
    answer.result.status = Status::interrupted;
    return answer;
  }
  Request request = request_of(map, run, start, goal);
  request.stop = stop;
  const bool shared = shares_islands(run);
  Ranks ranks;
  if (shared) {
    ranks = {crew()->number(), crew()->size(),
             [key = shared_key(run, "")](const auto& own) { return crew()->gather(key, own); },
             [](const auto& own) { return crew()->pass(own); }};
    request.ranks = &ranks;
  }
  Workspace workspace;  // to give back a large one takes time, which is not the plan's
  const auto begin = Clock::now();
  in_metres_asked(map, run, [&] {
    if (map.costs)
      set_costs(answer, map.costs->planner->plan(request, cost_options(run, observer)));
    else
      answer.result =
          map.planner->plan(request, run.params, {.workspace = &workspace, .observer = observer});
  });
  answer.elapsed_ms = ms_since(begin);
  if (shared) leave_to_leader();
  if (!run.with_optimum) return answer;
  if (map.costs)
    set_least_cost(answer, least_cost(map, run, request, again(stop, run.time_limit)));
  else
    add_optima(map, run, stop, answer);
  return answer;
}

CostResult least_cost(const LoadedMap& map, const RunOptions& run, Request request,
                      const StopCondition& stop) {
  request.target_gap = 0;
  request.stop = stop;
  return map.costs->planner->plan(request, {.params = optimum_params(run)});
}

void set_least_cost(Answer& answer, const CostResult& least) {
  if (least.path.empty() || answer.result.path.empty()) return;
  answer.optimum = least.cost;
  answer.over_costs->lower_bound = answer.result.lower_bound = least.lower_bound;
}

void in_metres_asked(const LoadedMap& map, const RunOptions& run,
                     const std::function<void()>& plan) {
  try {
    plan();
  } catch (const Error& fault) {
    if (!run.map.radius_metres || !fault.problem().starts_with("radius is ")) throw;
    throw Error(fault.code(),
                "radius is " + to_text(run.map.radius) + " m, cells are " +
                    to_text(map.frame->resolution) + " m",
                fault.remedy());
  }
}

CostOptions cost_options(const RunOptions& run, const Observer& observer) {
  const CostLayers& asked = run.map.costs;
  return {.params = run.params,
          .observer = observer,
          .eight_moves = asked.eight_moves,
          .proof = asked.proof};
}

std::string cost_text(const CostResult& result) {
  std::string text = "cost " + decimal_text(result.cost, 6);
  if (result.optimal) return text + ", proven least";
  if (const auto gap = result.gap())
    text += printed(", at most %.3f%% above the least", 100 * *gap);
  return text;
}

void set_costs(Answer& answer, const CostResult& found) {
  answer.result = found;
  answer.over_costs = found;
}

Route route_of(const LoadedMap& map, const RunOptions& run) {
  const bool exact = find_algorithm(run.params.algorithm()).kind == Algorithm::Kind::exact;
  return {.curved = exact && map.grown(),
          .corners = squeezes(run.params) ? Corners::allow : Corners::forbid};
}

void set_remedy(LoadedMap& map, const RunOptions& run, const std::stop_token& token,
                Answer& answer) {
  const Result& found = answer.result;
  const auto centred = [&](const Place& end) {
    return map.as_read().free(end.cell) && end.at() == centre(end.cell);
  };
  const bool near = found.status == Status::invalid && map.radius > 0 && found.nearest_reachable &&
                    found.nearest_reachable != found.nearest_free && centred(answer.start) &&
                    centred(answer.goal);
  if ((found.status != Status::unreachable && !near) || !run.via.empty()) return;
  answer.remedy = remedy_of(map, answer.start.cell, answer.goal.cell, route_of(map, run), token);
}

void set_optima(const RunOptions& run, std::optional<double> any_angle,
                std::optional<double> by_moves, Answer& answer) {
  if (!squeezes(run.params) || (answer.start.cell == answer.goal.cell && run.via.empty()))
    answer.optimum = any_angle;
  answer.grid_optimum = moves_on_cells(run.params) ? by_moves : answer.optimum;
}

std::optional<double> shortest_by_own_moves(const LoadedMap& map, const RunOptions& run,
                                            const Request& query, const StopCondition& stop) {
  const Grid& grid = map.grid();
  if (grid.blocked(query.start)) return std::nullopt;
  const auto joined = [&](Cell c) {
    return grid.free(c) && map.planner->connected(query.start, c, run.params.corners);
  };
  Cell goal = query.goal;
  if (!joined(goal)) {
    const auto nearest = query.goal_tolerance > 0
                             ? map.planner->nearest_reachable(goal, query.start, run.params.corners)
                             : std::nullopt;
    if (!nearest ||
        std::hypot(1.0 * nearest->x - goal.x, 1.0 * nearest->y - goal.y) > query.goal_tolerance)
      return std::nullopt;
    goal = *nearest;
  }
  return shortest_walk(grid, query.start, goal, run.params.neighbours, run.params.corners, stop);
}

std::optional<double> grid_gap(const Answer& answer, const Params& params) {
  const bool walked = params.polish == Polish::none && !answer.result.path.empty();
  double shortest = std::numeric_limits<double>::infinity();
  if (walked) shortest = answer.result.length;  // perhaps of several ants
  for (const double tour : answer.result.curves.cut_best) shortest = std::fmin(shortest, tour);
  if (!std::isfinite(shortest)) return std::nullopt;
  const auto gap = gap_to(answer.grid_optimum, shortest);
  if (!gap) return std::nullopt;
  return std::max(0.0, *gap);  // sums of the same moves may differ by rounding
}

Params optimum_params(const RunOptions& run) {
  Params params;
  params.threads = run.threads;
  return params;
}

}  // namespace lasius::tool
