#include "core/plan/answer.h"

#include <span>
#include <stdexcept>
#include <tuple>

#include "core/base/special_values.h"
#include "core/colony/colony.h"
#include "core/colony/own_update.h"
#include "core/cost/path_cost.h"
#include "core/disc/disc_cells.h"
#include "core/exact/anytime.h"
#include "core/genetic/grid_ga.h"
#include "core/loop/run_status.h"
#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"
#include "core/plan/alternatives.h"
#include "core/plan/disc_path.h"
#include "core/plan/exact_view.h"
#include "core/plan/legs.h"
#include "core/plan/plan_ends.h"
#include "core/plan/workspace.h"
#include "core/smooth/path_ends.h"
#include "lasius/path/path.h"

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

Result run_exact(const PlanningMap& map, const Request& request, const Places& places,
                 WorkspaceMemory& memory, const Observer& observer) {
  int improvements = 0;
  const OnImproved show = [&](const std::vector<Point>& path, double length, double bound) {
    return observer(ExactView(path, improvements++, length, bound)) == Go::on;
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
  if (map.labels != nullptr && memory.labels.search(map.grid, *map.graph, *map.labels, places.from,
                                                    places.to, options, request.stop, answer))
    return result_of(answer);
  if (map.stale != nullptr &&
      map.stale->search({memory.labels, memory.prepared}, map.grid, places.from, places.to, options,
                        request.stop, answer))
    return result_of(answer);
  // A deadline leaves no time for others, and who looks on sees the ordinary search.
  OwnGraph* const own = map.graph == nullptr && request.target_gap == 0 && !observer &&
                                request.stop.deadline == Clock::time_point::max()
                            ? map.own
                            : nullptr;
  if (const exact::CornerGraph* const graph = own != nullptr ? own->graph() : nullptr) {
    const bool told =
        memory.prepared.search_only(map.grid, *graph, places.from, places.to, request.stop, answer);
    own->count_asked(told);
    if (told) return result_of(answer);
  }
  exact::Anytime anytime(memory.bounding, map.grid, places.from, places.to, options, request.stop);
  if (map.graph != nullptr) {
    memory.prepared.search(map.grid, *map.graph, places.from, places.to, anytime.options(),
                           request.stop, answer);
  } else {
    memory.exact.search(map.grid, places.from, places.to, anytime.options(), request.stop, answer);
    if (own != nullptr) own->count_search(map.grid, memory.exact.counters(), request.stop);
  }
  anytime.merge(answer);
  return result_of(answer);
}

/// Puts the leg from the start to the way out before a plan; the ants' tours begin there.
void lead_out(Result& result, Point start, Point way_out, bool curved) {
  const double leg = distance(start, way_out);
  result.way_out = way_out;
  result.lower_bound.reset();
  result.optimal = false;
  for (auto* lengths : {&result.curves.best, &result.curves.iteration_best})
    for (double& length : *lengths) length += leg;
  if (result.path.empty()) return;
  result.path.insert(result.path.begin(), start);
  if (curved) result.curve.insert(result.curve.begin(), {.from = start, .to = way_out});
  result.length += leg;
}

/// What a walk's observer sees of it, with the best path as it ends at points.
class EndedView final : public GridProgress {
 public:
  EndedView(const GridProgress& walk, const std::vector<Point>& path, double length)
      : GridProgress(walk), walk_(walk), path_(path) {
    best_length = length;
  }
  std::vector<Point> path() const override { return path_; }
  int ants() const override { return walk_.ants(); }
  std::vector<Cell> tour(int ant) const override { return walk_.tour(ant); }
  std::vector<Cell> walk(int ant) const override { return walk_.walk(ant); }
  double pheromone(Cell c) const override { return walk_.pheromone(c); }

 private:
  const GridProgress& walk_;
  const std::vector<Point>& path_;
};

/// Runs an algorithm that walks between centres of cells, whose paths are to begin and end at other
/// points: `run(observer)`.
template <class Run>
Result with_ends(PathEnds ends, const StopCondition& stop, const Observer& observer,
                 const Run& run) {
  std::vector<double> best;
  std::vector<Point> path;
  double length = kInfinity, walked = kInfinity;
  const auto take = [&](const std::vector<Point>& found) {
    std::vector<Point> joined = ends.join(found, stop);
    const double now = path_length(joined);
    if (!(now < length)) return;
    length = now;
    path = std::move(joined);
  };
  const Observer look = [&](const GridProgress& progress) {
    if (progress.best_length < walked) {
      walked = progress.best_length;
      take(progress.path());
    }
    best.push_back(length < kInfinity ? length : kNaN);
    return observer ? observer(EndedView(progress, path, best.back())) : Go::on;
  };
  Result result = run(look);
  if (result.path.empty()) return result;
  take(result.path);
  best.resize(result.curves.best.size(), length);
  result.curves.best = std::move(best);
  result.path = std::move(path);
  result.length = length;
  return result;
}

}  // namespace

void check_serves(const Algorithm& algorithm, Disc robot) {
  if (robot.radius != 0 && algorithm.kind == Algorithm::Kind::exact)
    disc::check_disc_radius(robot.radius);
}

Corners corners_of(Corners asked, Disc robot) noexcept {
  return disc::has_space(robot.radius) ? disc::corners(robot.radius) : asked;
}

Corners corners_of_paths(const Params& params, Disc robot) {
  const bool exact = find_algorithm(params.algorithm()).kind == Algorithm::Kind::exact;
  const bool diagonal = !exact && params.neighbours != Neighbours::four;
  return corners_of(diagonal ? params.corners : Corners::forbid, robot);
}

namespace {

/// Why a path is none; `on_grid`: what of it goes over the map's cells.
std::optional<std::string> fault_of(const PlanningMap& map, const Result& result,
                                    std::span<const Point> on_grid, Corners corners) {
  if (space_of(map.disc) != nullptr)
    return disc_path_fault(map.disc->map(), map.disc->radius, result.path, result.curve);
  if (map.terrain == nullptr) return path_fault(map.grid, on_grid, corners);
  if (cost::cost_of(*map.terrain, result.path) < kInfinity) return std::nullopt;
  return "it enters what is blocked";
}

/// A question whose ends are judged, and who answers it.
struct Question {
  bool exact() const noexcept { return algorithm.kind == Algorithm::Kind::exact; }
  const disc::DiscSpace* space() const noexcept { return space_of(map.disc); }
  /// Is it a disc without a space? Its grown obstacles hold cells that legs to points may cross.
  bool legs_alone() const noexcept { return map.disc != nullptr && space() == nullptr; }

  const PlanningMap& map;
  const Params& params;
  const Algorithm& algorithm;
  const Observer& observer;
  const OwnRules& own;
  WorkspaceMemory& memory;
  Corners corners;  // of the path
  Places places;
  Request request;  // between the cells that are walked from and to
};

/// Between the centres of cells.
Result walk(const Question& q, const Observer& observer) {
  const Request& request = q.request;
  if (request.start == request.goal) {
    Result there;
    there.status = Status::solved;
    there.path = {centre(request.start)};
    return there;
  }
  if (q.algorithm.kind == Algorithm::Kind::genetic) {
    const auto joined = [&](Cell c) {
      return q.map.connected(request.start, c, q.corners).value_or(false);
    };
    return run_grid_ga(q.map.grid, request, q.params, joined, q.memory.genetic, observer,
                       q.space());
  }
  return q.map.search ? q.map.search(request, observer)
                      : run_colony(q.map.grid, request, q.params, q.memory.colony, observer, q.own,
                                   q.space(), q.map.terrain);
}

/// By an algorithm that walks between centres of cells.
Result walked(const Question& q) {
  const auto [from, to] = std::pair(q.places.from, q.places.to);
  Params polish = q.params;
  if (q.legs_alone()) polish.polish = Polish::none;
  const PathEnds joins(q.map.grid, q.space(), polish, from, to);
  const bool centres = from == centre(q.request.start) && to == centre(q.request.goal);
  const auto run = [&](const Observer& look) { return walk(q, look); };
  Result result = centres ? run(q.observer) : with_ends(joins, q.request.stop, q.observer, run);
  result.own_rules = q.algorithm.kind == Algorithm::Kind::colony && !q.own.none();
  return result;
}

/// A glance at the words along the path, which is not to be cut short.
/// @throws std::logic_error where it enters what is blocked.
void check_path(const Question& q, const Result& result) {
  if (result.path.size() < 2) return;
  std::span<const Point> on_grid = result.path;
  if (q.legs_alone() && q.places.from != centre(q.request.start)) on_grid = on_grid.subspan(1);
  if (q.legs_alone() && q.places.to != centre(q.request.goal))
    on_grid = on_grid.first(on_grid.size() - 1);
  // What an edge was stored for was looked at then, or since the map's edit.
  const bool stored = q.exact() && q.map.disc == nullptr && !q.map.search && !q.map.from_file &&
                      q.memory.exact_answer.stored_legs && on_grid.size() > 2;
  auto fault = fault_of(q.map, result, stored ? on_grid.first(2) : on_grid, q.corners);
  if (stored && !fault) fault = fault_of(q.map, result, on_grid.last(2), q.corners);
  if (fault) throw std::logic_error("a planned path is not valid: " + *fault);
}

/// Leg by leg, each a question of its own.
Result answer_through(const PlanningMap& map, const Request& asked, const Params& params,
                      const PlanOptions& options) {
  const auto plan = [&](const Request& leg) { return answer(map, leg, params, options); };
  Result whole = plan_legs(asked, plan);
  if (map.disc == nullptr) refuse_squeezes(map.grid, asked, corners_of_paths(params, {}), whole);
  return whole;
}

}  // namespace

Result answer(const PlanningMap& map, const Request& asked, const Params& given,
              const PlanOptions& options) {
  const OwnRules& own = options.own_rules;
  const Disc robot{map.disc != nullptr ? map.disc->radius : 0};
  const Algorithm& algorithm = find_algorithm(given.algorithm());
  check_alternatives(asked, algorithm, robot);
  if (!asked.via.empty()) return answer_through(map, asked, given, options);
  validate(given);
  check_certifies(algorithm, asked.target_gap);
  check_goal_tolerance(asked.goal_tolerance);
  check_serves(algorithm, robot);
  check_own_rules(own, map.grid, given);
  Params params = given;
  params.corners = corners_of_paths(params, robot);
  const disc::DiscSpace* const space = space_of(map.disc);
  const bool curved = space != nullptr && algorithm.kind == Algorithm::Kind::exact && !map.search;
  const Ends ends(map, curved ? space : nullptr, params.corners);
  const Asked start(ends.map_alone(), asked.start, asked.start_point);
  const Asked goal(ends.map_alone(), asked.goal, asked.goal_point);
  Places places;
  if (auto refusal = refused(ends, asked, start, goal, places)) return std::move(*refusal);
  Workspace* workspace = options.workspace;
  std::optional<Workspace> temporary;
  if (workspace == nullptr) workspace = &temporary.emplace();
  WorkspaceMemory& memory = WorkspaceMemory::of(*workspace);
  Question q{map, params, algorithm, options.observer, own, memory, params.corners, places, asked};
  std::tie(q.request.start, q.request.goal) =
      curved ? std::pair(cell_at(places.from), cell_at(places.to))
             : ends.walk(places.from, places.to);
  Result result;
  if (places.from == places.to) {
    static_cast<SearchResult&>(result) = already_there<SearchResult>();
    result.path = {places.from};
  } else if (q.exact()) {
    result = map.search ? map.search(q.request, options.observer)
                        : run_exact(map, q.request, places, memory, options.observer);
    // Cells may be joined where a disc is not: then the search has proven it. Of a point the cells
    // prove more: it is within rounding of a corner, and the search lost its ways.
    if (result.status == Status::unreachable && map.disc == nullptr) {
      result.status = Status::no_path;
      result.error = "start " + start.name() + " or goal " + goal.name() +
                     " is so near to what is blocked that no way was found from it; move it by "
                     "0.0001 cells, or onto the grid line";
      return result;
    }
    if (result.status == Status::unreachable) {
      Request apart_from = asked;
      apart_from.goal_tolerance = 0;  // what would be named as the nearest is what has no way
      return apart(ends, apart_from, start, goal, places.from);
    }
  } else {
    result = walked(q);
  }
  if (asked.goal_tolerance > 0) result.goal_reached = q.request.goal;
  check_path(q, result);
  if (asked.alternatives > 0 && result.optimal)
    add_alternatives(map, q.request, places, memory, result);
  if (places.way_out) lead_out(result, start.at, *places.way_out, curved);
  return result;
}

}  // namespace lasius
