#include "core/plan/answer.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "core/colony/colony.h"
#include "core/colony/own_update.h"
#include "core/exact/anytime.h"
#include "core/genetic/grid_ga.h"
#include "core/grid/cell_distance.h"
#include "core/loop/run_status.h"
#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"
#include "core/plan/workspace.h"
#include "lasius/path.h"

namespace lasius {
namespace {

/// What an observer sees of `exact`: one more path, shorter than those before.
class ExactView final : public GridProgress {
 public:
  ExactView(const std::vector<Point>& path, int number, double length, double bound) : path_(path) {
    iteration = number;
    best_length = length;
    lower_bound = bound;
  }
  std::vector<Point> path() const override { return path_; }

 private:
  const std::vector<Point>& path_;
};

Result run_exact(const Grid& grid, const exact::CornerGraph* graph, const Request& request,
                 WorkspaceMemory& memory, const Observer& observer) {
  ExactAnswer& answer = memory.exact_answer;
  int improvements = 0;
  const OnImproved show = [&](const std::vector<Point>& path, double length, double bound) {
    const ExactView view(path, improvements++, length, bound);
    observer(view);
    return !view.stopped();
  };
  exact::Anytime anytime(memory.bounding, grid, request.start, request.goal,
                         {.target_gap = request.target_gap, .improved = observer ? &show : nullptr},
                         request.stop);
  if (graph != nullptr) {
    memory.prepared.search(grid, *graph, request.start, request.goal, anytime.options(),
                           request.stop, answer);
  } else {
    memory.exact.search(grid, request.start, request.goal, anytime.options(), request.stop, answer);
  }
  anytime.merge(answer);
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

/// Whether a cell is joined to another one; not when stopped.
std::function<bool(Cell)> joined_to(const PlanningMap& map, Cell from, Corners corners) {
  return [&map, from, corners](Cell c) { return map.connected(from, c, corners) == true; };
}

/// What a sentence about an end that is bad goes on with.
std::string nearest_text(bool at_start, Cell free, const std::optional<Cell>& reachable) {
  const std::string nearest = "; the nearest free cell ";
  if (!reachable || *reachable == free) return nearest + "is " + cell_name(free);
  return nearest + (at_start ? "from which the goal" : "that") + " can be reached" +
         (at_start ? "" : " from the start") + " is " + cell_name(*reachable) + "; " +
         cell_name(free) + " is nearer, but " +
         (at_start ? "does not lead there" : "cannot be reached");
}

/// The answer to a start or goal that is blocked or outside.
Result invalid(const PlanningMap& map, bool at_start, const Request& request, Corners corners) {
  const Cell cell = at_start ? request.start : request.goal;
  const Cell other = at_start ? request.goal : request.start;
  const auto [fault, text] = fault_of_end(map.grid, at_start, cell);
  auto result = failed<Result>(Status::invalid, fault, text);
  std::function<bool(Cell)> joined;
  if (map.grid.free(other)) joined = joined_to(map, other, corners);
  const bool whole = find_nearest(result, map.grid, cell, request.stop.token, joined);
  if (result.nearest_free) {
    result.error += nearest_text(at_start, *result.nearest_free, result.nearest_reachable);
  } else if (whole) {
    result.error += "; the map has no free cell";
  }
  return result;
}

/// Why no path leads to the goal, or nothing where one does; not `connected` when stopped.
std::optional<Result> refused(const PlanningMap& map, const Request& request, Corners corners) {
  const auto& [start, goal] = std::pair(request.start, request.goal);
  if (map.grid.blocked(start)) return invalid(map, true, request, corners);
  if (map.grid.blocked(goal)) return invalid(map, false, request, corners);
  if (start == goal) return std::nullopt;
  const auto connected = map.connected(start, goal, corners);
  if (connected == true) return std::nullopt;
  Result result;
  if (!connected) {
    end_run(result, request.stop.poll(), Status::limit);
    return result;
  }
  result = failed<Result>(Status::unreachable, Fault::disconnected,
                          "start " + cell_name(start) + " and goal " + cell_name(goal) +
                              " lie in different regions of free cells");
  if (request.goal_tolerance > 0) {
    const StopCondition no_deadline{.token = request.stop.token};
    Poller poller(no_deadline);
    result.nearest_reachable = nearest_free(map.grid, goal, poller, joined_to(map, start, corners));
  }
  return result;
}

/// Makes the nearest cell that can be reached the goal, or says why not.
bool take_nearest(Request& request, Result& refusal) {
  const auto& nearest = refusal.nearest_reachable;
  const bool at_goal = refusal.fault == Fault::goal_blocked ||
                       refusal.fault == Fault::goal_outside || refusal.fault == Fault::disconnected;
  if (!nearest || !at_goal || request.goal_tolerance == 0) return false;
  const double away = distance(*nearest, request.goal);
  if (away > request.goal_tolerance) {
    refusal.error += "; the nearest cell that can be reached, " + cell_name(*nearest) + ", is " +
                     number_text(away) + " from the goal, its tolerance " +
                     number_text(request.goal_tolerance);
    return false;
  }
  request.goal = *nearest;
  return true;
}

}  // namespace

std::pair<Fault, std::string> fault_of_end(const Grid& grid, bool at_start, Cell cell) {
  const bool inside = grid.contains(cell);
  const Fault fault = at_start ? (inside ? Fault::start_blocked : Fault::start_outside)
                               : (inside ? Fault::goal_blocked : Fault::goal_outside);
  return {fault, (at_start ? "start " : "goal ") + cell_name(cell) +
                     (inside ? " is blocked" : " is outside the map")};
}

Corners corners_of_paths(const Params& params) {
  const bool exact = find_algorithm(params.algorithm()).kind == Algorithm::Kind::exact;
  return exact ? Corners::forbid : params.corners;
}

Result answer(const PlanningMap& map, const Request& asked, const Params& params,
              Workspace* workspace, const Observer& observer, const OwnRules& own) {
  validate(params, own);
  const Algorithm& algorithm = find_algorithm(params.algorithm());
  check_certifies(algorithm, asked.target_gap);
  check_goal_tolerance(asked.goal_tolerance);
  const Grid& grid = map.grid;
  check_own_rules(own, grid, params);
  const Corners corners = corners_of_paths(params);
  Request request = asked;
  if (auto refusal = refused(map, asked, corners); refusal && !take_nearest(request, *refusal))
    return std::move(*refusal);
  Result result;
  if (request.goal_tolerance > 0) result.goal_reached = request.goal;
  if (request.start == request.goal) {
    static_cast<SearchResult&>(result) = already_there<SearchResult>();
    result.path = {centre(request.start)};
    return result;
  }

  std::optional<Workspace> temporary;
  if (workspace == nullptr) workspace = &temporary.emplace();
  WorkspaceMemory& memory = WorkspaceMemory::of(*workspace);
  switch (algorithm.kind) {
    case Algorithm::Kind::exact:
      result = run_exact(grid, map.graph, request, memory, observer);
      break;
    case Algorithm::Kind::genetic: {
      const auto joined = [&](Cell c) {
        return map.connected(request.start, c, corners).value_or(false);
      };
      result = run_grid_ga(grid, request, params, joined, memory.genetic, observer);
      break;
    }
    case Algorithm::Kind::colony:
      result = map.colony ? map.colony(request, observer)
                          : run_colony(grid, request, params, memory.colony, observer, own);
      result.own_rules = !own.none();
      break;
  }
  if (request.goal_tolerance > 0) result.goal_reached = request.goal;
  if (result.path.empty()) return result;
  // Not to be cut short: a glance at the words along the path.
  if (const auto fault = path_fault(grid, result.path, corners)) {
    throw std::logic_error("a planned path is not valid: " + *fault);
  }
  return result;
}

}  // namespace lasius
