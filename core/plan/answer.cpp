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
#include "core/plan/disc_path.h"
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

Result run_exact(const PlanningMap& map, const Request& request, WorkspaceMemory& memory,
                 const Observer& observer) {
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
    memory.disc.search(*map.disc->space, map.disc_graph, centre(request.start),
                       centre(request.goal), options, request.stop, answer);
    Result result = result_of(answer);
    if (!result.path.empty()) result.curve = answer.curve;
    return result;
  }
  ExactAnswer& answer = memory.exact_answer;
  exact::Anytime anytime(memory.bounding, map.grid, request.start, request.goal, options,
                         request.stop);
  if (map.graph != nullptr) {
    memory.prepared.search(map.grid, *map.graph, request.start, request.goal, anytime.options(),
                           request.stop, answer);
  } else {
    memory.exact.search(map.grid, request.start, request.goal, anytime.options(), request.stop,
                        answer);
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
  std::optional<bool> joined(Cell a, Cell b) const {
    if (space_ == nullptr) return map_.connected(a, b, corners_);
    return space_->joined(centre(a), centre(b));
  }
  /// Of those that serve, if given of those joined to `other`, the nearest to `c`. It is found
  /// whatever the deadline.
  std::optional<Cell> nearest(Cell c, const std::stop_token& token,
                              const std::optional<Cell>& other = {}) const {
    const StopCondition no_deadline{.token = token};
    Poller poller(no_deadline);
    if (space_ != nullptr) return nearest_clear(*space_, c, poller, other);
    if (!other) return nearest_free(map_.grid, c, poller);
    const auto joined = [&](Cell at) {
      return map_.connected(*other, at, corners_).value_or(false);
    };
    return nearest_free(map_.grid, c, poller, joined);
  }
  /// What is wrong with a cell that does not serve.
  std::pair<Fault, std::string> fault(bool at_start, Cell c) const {
    auto [fault, text] =
        fault_of_end(map_.disc != nullptr ? map_.disc->map() : map_.grid, at_start, c);
    if (map_.disc == nullptr || map_.disc->map().blocked(c)) return {fault, text};
    text.replace(
        text.find(" is blocked"), std::string::npos,
        " is nearer to what is blocked than the radius of " + number_text(map_.disc->radius));
    if (space_ == nullptr && map_.disc->space && map_.disc->space->clear(centre(c)))
      text +=
          ", though its centre is not: exact plans from there, other algorithms on cells that "
          "keep the radius all over";
    return {fault, text};
  }

 private:
  const PlanningMap& map_;
  const disc::DiscSpace* space_;
  Corners corners_;
};

/// What a sentence about such an end goes on with.
std::string nearest_text(bool at_start, Cell free, const std::optional<Cell>& reachable) {
  const std::string nearest = "; the nearest free cell ";
  if (!reachable || *reachable == free) return nearest + "is " + cell_name(free);
  return nearest + (at_start ? "from which the goal" : "that") + " can be reached" +
         (at_start ? "" : " from the start") + " is " + cell_name(*reachable) + "; " +
         cell_name(free) + " is nearer, but " +
         (at_start ? "does not lead there" : "cannot be reached");
}

/// The answer to a start or goal that is blocked or outside.
Result invalid(const Ends& ends, bool at_start, const Request& request) {
  const Cell cell = at_start ? request.start : request.goal;
  const Cell other = at_start ? request.goal : request.start;
  const std::stop_token& token = request.stop.token;
  const auto [fault, text] = ends.fault(at_start, cell);
  auto result = failed<Result>(Status::invalid, fault, text);
  result.nearest_free = ends.nearest(cell, token);
  if (result.nearest_free && ends.serves(other)) {
    result.nearest_reachable = ends.joined(other, *result.nearest_free) == true
                                   ? result.nearest_free
                                   : ends.nearest(cell, token, other);
  }
  if (result.nearest_free) {
    result.error += nearest_text(at_start, *result.nearest_free, result.nearest_reachable);
  } else if (!token.stop_requested()) {
    result.error += "; the map has no free cell";
  }
  return result;
}

/// The answer where start and goal are not joined.
Result apart(const Ends& ends, const Request& request) {
  auto result =
      failed<Result>(Status::unreachable, Fault::disconnected,
                     "start " + cell_name(request.start) + " and goal " + cell_name(request.goal) +
                         " lie in different regions of free cells");
  if (request.goal_tolerance > 0)
    result.nearest_reachable = ends.nearest(request.goal, request.stop.token, request.start);
  return result;
}

/// Why no path leads to the goal, or nothing where one does; not `connected` when stopped.
std::optional<Result> refused(const Ends& ends, const Request& request) {
  const auto& [start, goal] = std::pair(request.start, request.goal);
  if (!ends.serves(start)) return invalid(ends, true, request);
  if (!ends.serves(goal)) return invalid(ends, false, request);
  if (start == goal) return std::nullopt;
  const auto joined = ends.joined(start, goal);
  if (joined == true) return std::nullopt;
  if (joined) return apart(ends, request);
  Result result;
  end_run(result, request.stop.poll(), Status::limit);
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

void check_serves(const Algorithm& algorithm, Disc robot) {
  if (robot.radius != 0 && algorithm.kind == Algorithm::Kind::exact)
    disc::check_disc_radius(robot.radius);
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
  check_serves(algorithm, {map.disc != nullptr ? map.disc->radius : 0});
  const Grid& grid = map.grid;
  check_own_rules(own, grid, params);
  const Corners corners = corners_of_paths(params);
  const bool curved = map.disc != nullptr && algorithm.kind == Algorithm::Kind::exact;
  const Ends ends(map, curved ? &*map.disc->space : nullptr, corners);
  Request request = asked;
  if (auto refusal = refused(ends, asked); refusal && !take_nearest(request, *refusal))
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
      result = run_exact(map, request, memory, observer);
      // Cells may be joined where a disc is not: then the search has proven it.
      if (result.status == Status::unreachable) {
        request = asked;
        request.goal_tolerance = 0;  // what would be named as the nearest is what has no way
        return apart(ends, request);
      }
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
  const auto fault =
      curved ? disc_path_fault(map.disc->map(), map.disc->radius, result.path, result.curve)
             : path_fault(grid, result.path, corners);
  if (fault) throw std::logic_error("a planned path is not valid: " + *fault);
  return result;
}

}  // namespace lasius
