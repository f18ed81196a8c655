#include "core/plan/answer.h"

#include <stdexcept>
#include <string>

#include "core/base/poller.h"
#include "core/colony/colony.h"
#include "core/colony/own_update.h"
#include "core/exact/anytime.h"
#include "core/genetic/grid_ga.h"
#include "core/grid/nearest_free.h"
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

/// The answer to a start or goal that is blocked or outside.
Result invalid(const Grid& grid, bool at_start, Cell cell, const std::stop_token& token) {
  const auto [fault, text] = fault_of_end(grid, at_start, cell);
  auto result = failed<Result>(Status::invalid, fault, text);
  // It is named whatever the deadline.
  const StopCondition no_deadline{.token = token};
  Poller poller(no_deadline);
  result.nearest_free = nearest_free(grid, cell, poller);
  if (result.nearest_free) {
    result.error += "; the nearest free cell is " + cell_name(*result.nearest_free);
  } else if (!poller.stopped()) {
    result.error += "; the map has no free cell";
  }
  return result;
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

Result answer(const PlanningMap& map, const Request& request, const Params& params,
              Workspace* workspace, const Observer& observer, const OwnRules& own) {
  validate(params, own);
  const Algorithm& algorithm = find_algorithm(params.algorithm());
  check_certifies(algorithm, request.target_gap);
  const Grid& grid = map.grid;
  check_own_rules(own, grid, params);
  if (grid.blocked(request.start)) return invalid(grid, true, request.start, request.stop.token);
  if (grid.blocked(request.goal)) return invalid(grid, false, request.goal, request.stop.token);
  if (request.start == request.goal) {
    auto result = already_there<Result>();
    result.path = {centre(request.start)};
    return result;
  }
  const Corners corners = corners_of_paths(params);
  const auto connected = map.connected(request.start, request.goal, corners);
  Result result;
  if (!connected) {
    end_run(result, request.stop.poll(), Status::limit);
    return result;
  }
  if (!*connected) {
    return failed<Result>(Status::unreachable, Fault::disconnected,
                          "start " + cell_name(request.start) + " and goal " +
                              cell_name(request.goal) + " lie in different regions of free cells");
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
  if (result.path.empty()) return result;
  // Not to be cut short: a glance at the words along the path.
  if (const auto fault = path_fault(grid, result.path, corners)) {
    throw std::logic_error("a planned path is not valid: " + *fault);
  }
  return result;
}

}  // namespace lasius
