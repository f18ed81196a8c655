#include "core/plan/answer.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/nearest_text.h"
#include "core/base/special_values.h"
#include "core/colony/colony.h"
#include "core/colony/own_update.h"
#include "core/disc/disc_cells.h"
#include "core/disc/sweep.h"
#include "core/exact/anytime.h"
#include "core/genetic/grid_ga.h"
#include "core/grid/cell_distance.h"
#include "core/grid/rings.h"
#include "core/loop/run_status.h"
#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"
#include "core/plan/disc_path.h"
#include "core/plan/exact_view.h"
#include "core/plan/workspace.h"
#include "lasius/clearance.h"
#include "lasius/path.h"

namespace lasius {
namespace {

Result result_of(const ExactAnswer& answer) {
  Result result;
  switch (answer.end) {
    case ExactEnd::proven:
    case ExactEnd::target_gap:
      result.status = Status::solved;
      break;
    case ExactEnd::unreachable:
      return failed<Result>(Status::unreachable, Fault::disconnected, {});
    case ExactEnd::stopped:
      end_run(result, answer.cause, Status::limit);
      break;
  }
  result.path = answer.path;
  if (!result.path.empty()) result.length = answer.length;
  result.lower_bound = answer.lower_bound;
  result.optimal = answer.optimal;
  return result;
}

/// Where a plan begins and ends: cells' centres, but of a disc's curve.
struct Places {
  Point from, to;
  std::optional<Point> way_out = {};  ///< from where it begins, if not at the start
};

Result run_exact(const PlanningMap& map, const Request& request, const Places& places,
                 WorkspaceMemory& memory, const Observer& observer) {
  int improvements = 0;
  const OnImproved show = [&](const std::vector<Point>& path, double length, double bound) {
    const ExactView view(path, improvements++, length, bound);
    observer(view);
    return !view.stopped();
  };
  const ExactOptions options{.target_gap = request.target_gap,
                             .improved = observer ? &show : nullptr};
  if (map.disc != nullptr) {
    disc::DiscAnswer& answer = memory.disc_answer;
    memory.disc.search(*map.disc->space, map.disc_graph, places.from, places.to, options,
                       request.stop, answer);
    Result result = result_of(answer);
    if (!result.path.empty()) result.curve = answer.curve;
    return result;
  }
  ExactAnswer& answer = memory.exact_answer;
  exact::Anytime anytime(memory.bounding, map.grid, places.from, places.to, options, request.stop);
  if (map.graph != nullptr) {
    memory.prepared.search(map.grid, *map.graph, places.from, places.to, anytime.options(),
                           request.stop, answer);
  } else {
    memory.exact.search(map.grid, places.from, places.to, anytime.options(), request.stop, answer);
  }
  anytime.merge(answer);
  return result_of(answer);
}

/// Where a path may begin and end: cells that are free, or for `exact` and a disc those whose
/// centres are clear.
class Ends {
 public:
  Ends(const PlanningMap& map, const disc::DiscSpace* space, Corners corners)
      : map_(map), space_(space), corners_(corners) {}

  const PlanningMap& map() const noexcept { return map_; }
  bool serves(Cell c) const {
    return space_ == nullptr ? map_.grid.free(c) : space_->clear(centre(c));
  }
  /// Of two that serve; nothing if stopped.
  std::optional<bool> joined(Point a, Point b) const {
    if (space_ == nullptr) return map_.connected(cell_at(a), cell_at(b), corners_);
    return space_->joined(a, b);
  }
  /// Of those that serve, if given of those joined to `other`, the nearest to `c`. It is found
  /// whatever the deadline.
  std::optional<Cell> nearest(Cell c, const std::stop_token& token,
                              const std::optional<Point>& other = {}) const {
    const StopCondition no_deadline{.token = token};
    Poller poller(no_deadline);
    if (space_ != nullptr) return nearest_clear(*space_, c, poller, other);
    if (!other) return nearest_free(map_.grid, c, poller);
    const auto leads_on = [&](Cell at) { return joined(*other, centre(at)).value_or(false); };
    return nearest_free(map_.grid, c, poller, leads_on);
  }
  /// The same, of a disc's curve any point, if it is not walked.
  std::optional<Point> nearest_point(Cell c, const std::stop_token& token, Point other) const {
    if (space_ == nullptr || map_.walked) {
      const auto cell = nearest(c, token, other);
      return cell ? std::optional(centre(*cell)) : std::nullopt;
    }
    const StopCondition no_deadline{.token = token};
    Poller poller(no_deadline);
    return space_->way_out(centre(c), poller, other);
  }
  /// From a start that does not serve, but lies in a free cell: the nearest place that serves, if
  /// given of those joined to `goal`, to which a leg leads that is nowhere nearer to what is
  /// blocked than the start.
  std::optional<Point> way_out(Cell start, const std::optional<Point>& goal, Poller& poller) const {
    if (map_.walked || map_.disc == nullptr || map_.disc->map().blocked(start)) return std::nullopt;
    const Grid& map = map_.disc->map();
    const Point from = centre(start);
    const double most = std::min(map_.disc->radius, 1.0 * map.width() + map.height());
    const double clearance = nearest_blocked(map, from, most).distance - disc::kSlack;
    const auto leads_there = [&](Point to) { return disc::sweeps_clear(map, from, to, clearance); };
    if (space_ != nullptr) return space_->way_out(from, poller, goal, leads_there);
    std::optional<Point> best;
    double nearest = kInfinity;
    for_rings(map, start, nearest, poller, [&](Cell c) {
      const Point to = centre(c);
      if (map_.grid.blocked(c) || !(disc::distance(from, to) < nearest) || !leads_there(to)) return;
      if (goal && joined(to, *goal) != true) return;
      nearest = disc::distance(from, to);
      best = to;
    });
    return best;
  }
  /// What is wrong with a cell that does not serve.
  std::pair<Fault, std::string> fault(bool at_start, Cell c) const {
    if (map_.disc == nullptr) return fault_of_end(map_.grid, at_start, c);
    const Grid& map = map_.disc->map();
    if (map.blocked(c)) return fault_of_end(map, at_start, c);
    return fault_of_end(
        map, at_start, c,
        "nearer to what is blocked than the radius of " + rounded_text(map_.disc->radius));
  }

 private:
  const PlanningMap& map_;
  const disc::DiscSpace* space_;
  Corners corners_;
};

/// The answer to a start or goal that is blocked or outside; `other` is the other end, if good.
Result invalid(const Ends& ends, bool at_start, const Request& request,
               const std::optional<Point>& other) {
  const Cell cell = at_start ? request.start : request.goal;
  const std::stop_token& token = request.stop.token;
  const auto [fault, text] = ends.fault(at_start, cell);
  auto result = failed<Result>(Status::invalid, fault, text);
  result.nearest_free = ends.nearest(cell, token);
  if (result.nearest_free && other) {
    result.nearest_reachable = ends.joined(*other, centre(*result.nearest_free)) == true
                                   ? result.nearest_free
                                   : ends.nearest(cell, token, other);
  }
  if (result.nearest_free) {
    const auto& reachable = result.nearest_reachable;
    result.error += nearest_text(at_start, cell_name(*result.nearest_free),
                                 reachable ? std::optional(cell_name(*reachable)) : std::nullopt);
  } else if (!token.stop_requested()) {
    result.error += "; the map has no free cell";
  }
  return result;
}

/// The answer where start and goal are not joined; `from` is where the plan begins.
Result apart(const Ends& ends, const Request& request, Point from) {
  auto result =
      failed<Result>(Status::unreachable, Fault::disconnected,
                     "start " + cell_name(request.start) + " and goal " + cell_name(request.goal) +
                         " lie in different regions of free cells");
  if (request.goal_tolerance > 0)
    result.nearest_reachable = ends.nearest(request.goal, request.stop.token, from);
  return result;
}

Result stopped(StopCondition::Cause cause) {
  Result result;
  end_run(result, cause, Status::limit);
  return result;
}

/// Finds where the plan begins and ends, or why there is none.
std::optional<Result> refused(const Ends& ends, const Request& request, Places& places) {
  const auto& [start, goal] = std::pair(request.start, request.goal);
  places = {centre(start), centre(goal)};
  const bool goal_serves = ends.serves(goal);
  if (!ends.serves(start)) {
    const auto to = goal_serves ? std::optional(places.to) : std::nullopt;
    Poller poller(request.stop);
    places.way_out = ends.way_out(start, to, poller);
    if (poller.stopped()) return stopped(poller.cause());
    if (!places.way_out) return invalid(ends, true, request, to);
    places.from = *places.way_out;
  }
  if (goal_serves) {
    const auto joined = places.from == places.to ? true : ends.joined(places.from, places.to);
    if (!joined) return stopped(request.stop.poll());
    if (*joined) return std::nullopt;
  }
  const double tolerance = request.goal_tolerance;
  if (tolerance > 0) {
    const auto nearest = ends.nearest_point(goal, request.stop.token, places.from);
    if (nearest && disc::distance(*nearest, places.to) <= tolerance) {
      places.to = *nearest;
      return std::nullopt;
    }
  }
  Result refusal =
      goal_serves ? apart(ends, request, places.from) : invalid(ends, false, request, places.from);
  if (const auto& nearest = refusal.nearest_reachable; nearest && tolerance > 0)
    refusal.error += "; the nearest cell that can be reached, " + cell_name(*nearest) + ", is " +
                     rounded_text(distance(*nearest, goal)) +
                     " cells from the goal, its tolerance " + rounded_text(tolerance);
  return refusal;
}

/// Puts the leg from the start to the way out before a plan; the ants' tours begin there.
void lead_out(Result& result, Point start, Point way_out, bool curved) {
  const double leg = disc::distance(start, way_out);
  result.way_out = way_out;
  result.lower_bound.reset();
  result.optimal = false;
  for (auto* lengths : {&result.best, &result.iteration_best})
    for (double& length : *lengths) length += leg;
  if (result.path.empty()) return;
  result.path.insert(result.path.begin(), start);
  if (curved) result.curve.insert(result.curve.begin(), {.from = start, .to = way_out});
  result.length += leg;
}

}  // namespace

std::pair<Fault, std::string> fault_of_end(const Grid& grid, bool at_start, Cell cell,
                                           const std::string& what) {
  const bool inside = grid.contains(cell);
  const Fault fault = at_start ? (inside ? Fault::start_blocked : Fault::start_outside)
                               : (inside ? Fault::goal_blocked : Fault::goal_outside);
  return {fault, (at_start ? "start " : "goal ") + cell_name(cell) + " is " +
                     (inside ? what : "outside the map")};
}

void check_serves(const Algorithm& algorithm, Disc robot) {
  if (robot.radius != 0 && algorithm.kind == Algorithm::Kind::exact)
    disc::check_disc_radius(robot.radius);
}

Corners corners_of(Corners asked, Disc robot) noexcept {
  return disc::has_space(robot.radius) ? disc::corners(robot.radius) : asked;
}

Corners corners_of_paths(const Params& params, Disc robot) {
  const bool exact = find_algorithm(params.algorithm()).kind == Algorithm::Kind::exact;
  return corners_of(exact ? Corners::forbid : params.corners, robot);
}

Result answer(const PlanningMap& map, const Request& asked, const Params& given,
              Workspace* workspace, const Observer& observer, const OwnRules& own) {
  validate(given, own);
  const Algorithm& algorithm = find_algorithm(given.algorithm());
  check_certifies(algorithm, asked.target_gap);
  check_goal_tolerance(asked.goal_tolerance);
  const Disc robot{map.disc != nullptr ? map.disc->radius : 0};
  check_serves(algorithm, robot);
  const Grid& grid = map.grid;
  check_own_rules(own, grid, given);
  Params params = given;
  params.corners = corners_of(params.corners, robot);
  const Corners corners = corners_of_paths(params, robot);
  const disc::DiscSpace* const space =
      map.disc != nullptr && map.disc->space ? &*map.disc->space : nullptr;
  const bool curved = space != nullptr && algorithm.kind == Algorithm::Kind::exact;
  const Ends ends(map, curved ? space : nullptr, corners);
  Places places;
  if (auto refusal = refused(ends, asked, places)) return std::move(*refusal);
  Request request = asked;
  request.start = cell_at(places.from);
  request.goal = cell_at(places.to);
  std::optional<Workspace> temporary;
  if (workspace == nullptr) workspace = &temporary.emplace();
  WorkspaceMemory& memory = WorkspaceMemory::of(*workspace);
  Result result;
  if (places.from == places.to) {
    static_cast<SearchResult&>(result) = already_there<SearchResult>();
    result.path = {places.from};
  } else if (algorithm.kind == Algorithm::Kind::exact) {
    result = run_exact(map, request, places, memory, observer);
    // Cells may be joined where a disc is not: then the search has proven it.
    if (result.status == Status::unreachable) {
      request = asked;
      request.goal_tolerance = 0;  // what would be named as the nearest is what has no way
      return apart(ends, request, places.from);
    }
  } else if (algorithm.kind == Algorithm::Kind::genetic) {
    const auto joined = [&](Cell c) {
      return map.connected(request.start, c, corners).value_or(false);
    };
    result = run_grid_ga(grid, request, params, joined, memory.genetic, observer, space);
  } else {
    result = map.colony ? map.colony(request, observer)
                        : run_colony(grid, request, params, memory.colony, observer, own, space);
    result.own_rules = !own.none();
  }
  if (request.goal_tolerance > 0) result.goal_reached = request.goal;
  // Not to be cut short: a glance at the words along the path.
  if (result.path.size() > 1) {
    const auto fault = space != nullptr ? disc_path_fault(map.disc->map(), map.disc->radius,
                                                          result.path, result.curve)
                                        : path_fault(grid, result.path, corners);
    if (fault) throw std::logic_error("a planned path is not valid: " + *fault);
  }
  if (places.way_out) lead_out(result, centre(asked.start), *places.way_out, curved);
  return result;
}

}  // namespace lasius
