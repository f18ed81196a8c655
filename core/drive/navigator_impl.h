// What a Navigator holds, and how it goes on from step to step.
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/special_values.h"
#include "core/disc/disc_cells.h"
#include "core/disc/disc_graph.h"
#include "core/disc/disc_space.h"
#include "core/disc/sweep.h"
#include "core/drive/doubts.h"
#include "core/drive/edited_map.h"
#include "core/drive/live_costs.h"
#include "core/drive/live_map.h"
#include "core/drive/path_walker.h"
#include "core/grid/cell_distance.h"
#include "core/grid/grid_view.h"
#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"
#include "core/plan/answer.h"
#include "core/plan/disc_path.h"
#include "core/plan/stale_answers.h"
#include "core/plan/workspace.h"
#include "core/smooth/taut_string.h"
#include "lasius/drive/navigator.h"
#include "lasius/path/path.h"

namespace lasius {

/// @throws Error(invalid_parameter) unless the algorithm is of the kind that an option is for.
inline void check_kind(const Algorithm& algorithm, Algorithm::Kind kind, const char* option,
                       const char* whose) {
  if (algorithm.kind == kind) return;
  refuse(std::string(option) + " is set, which " + std::string(algorithm.name) + " ignores",
         std::string("leave it out, or take ") + whose);
}

class Navigator::Impl {
 public:
  using Connectivity = Components::Connectivity;

  Impl(Grid grid, Cell to, const NavigatorOptions& given)
      : goal(to), options(given), map(std::move(grid), given.radius) {
    validate(options.params);
    const Algorithm& algorithm = find_algorithm(options.params.algorithm());
    check_certifies(algorithm, options.target_gap);
    check_goal_tolerance(options.goal_tolerance);
    require_parameter(options.doubt_after >= 0, "doubt_after", options.doubt_after,
                      "it must be 0 (never) or more steps");
    if (options.prepare) check_kind(algorithm, Algorithm::Kind::exact, "prepare", "exact");
    if (options.search_on) check_kind(algorithm, Algorithm::Kind::colony, "search_on", "a colony");
    corners = corners_of_paths(options.params, {given.radius});
    if (options.costs || options.inflation) take_costs(algorithm);
    if (disc::has_space(given.radius))
      robot_disc.emplace(DiscMap{given.radius, disc::DiscSpace::make(map.map(), given.radius)});
    if (algorithm.kind == Algorithm::Kind::colony) send_colony(goal);
    taut = algorithm.kind == Algorithm::Kind::exact || options.params.polish == Polish::taut;
    if (corners == Corners::allow) eight.emplace(map.passable(), Connectivity::eight);
    if (options.prepare) prepare(*options.prepare);
  }

  void take_costs(const Algorithm& algorithm) {
    check_kind(algorithm, Algorithm::Kind::exact, "costs", "exact");
    if (options.prepare) refuse("prepare is set, and so are costs", "leave one out");
    if (options.target_gap > 0) refuse("target_gap is set, and so are costs", "leave one out");
    const Grid& grid = map.map();
    const CostField plain(grid.width(), grid.height());
    costs.emplace(map, options.costs ? *options.costs : plain, options.inflation,
                  rule_of_walks(corners));
    options.costs.reset();
  }
  /// A trail leads to one goal.
  void send_colony(Cell to) {
    Params params = options.params;
    if (params.islands > 1)
      refuse("islands is " + std::to_string(params.islands) +
                 ", but one colony follows a map that changes",
             "set islands to 1");
    params.corners = corners_of_paths(params, {options.radius});
    if (robot_disc && space() == nullptr)  // a step was stopped
      robot_disc->space = disc::DiscSpace::make(map.map(), options.radius);
    colony.emplace(map.passable(), to, params, space());
  }
  const disc::DiscSpace* space() const noexcept {
    return robot_disc ? space_of(&*robot_disc) : nullptr;
  }
  /// Tells a disc's free space of the edits since the last call, and looks whether the way holds.
  /// False when stopped: then there is no space until the next call.
  bool update_space(const StopCondition& stop) {
    if (!robot_disc || (edited.empty() && robot_disc->space)) return true;
    if (robot_disc->space) {
      std::erase_if(edited,
                    [&](Cell c) { return space()->map().blocked(c) == map.map().blocked(c); });
      std::ranges::sort(edited, {}, [](Cell c) { return std::pair(c.y, c.x); });
      edited.erase(std::unique(edited.begin(), edited.end()), edited.end());
      if (!robot_disc->space->update(map.map(), edited, stop)) robot_disc->space.reset();
    } else {
      robot_disc->space = disc::DiscSpace::make(map.map(), options.radius, stop);
    }
    edited.clear();
    if (!robot_disc->space) return false;
    if (!std::exchange(wall_rose, false) || way.path.empty()) return true;
    // What leads out keeps no radius.
    holds = holds && !way.way_out && keeps(way.path[0], way.path[0]);
    for (std::size_t i = 1; i < way.path.size() && holds; ++i)
      holds = keeps(way.path[i - 1], way.path[i]);
    for (std::size_t i = 1; i < way.walk.size() && holds; ++i)
      holds = keeps(centre(way.walk[i - 1]), centre(way.walk[i]));
    if (holds && !way.curve.empty())  // its arcs lie inside of the path
      holds = !disc_path_fault(map.map(), options.radius, way.path, way.curve);
    return true;
  }
  /// What is planned becomes the polyline, which keeps the radius as well.
  static void leave_curve(Result& result) {
    if (result.curve.empty()) return;
    result.curve.clear();
    result.length = path_length(result.path);
    result.optimal = false;
  }
  /// Between points that may not be clear any more.
  bool keeps(Point a, Point b) const noexcept {
    return disc::sweeps_clear(map.map(), a, b, options.radius - 2 * disc::kSlack);
  }

  void prepare(const PrepareOptions& how) {
    check_threads(how.threads);
    const auto begin = Clock::now();
    if (robot_disc) {
      disc_graph = disc::DiscGraph::make(*space(), how, preparation);
    } else if (auto graph = exact::CornerGraph::make(map.passable(), how, preparation)) {
      auto labels = how.labels
                        ? exact::CornerLabels::make(map.passable(), *graph, how, preparation.labels)
                        : nullptr;
      prepared = std::make_shared<const PreparedMap>(
          PreparedMap{map.passable(), std::move(graph), std::move(labels)});
    }
    preparation.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }

  const EditedMap::OnChange on_change = [this](const Rectangle& part, std::span<const Cell> cells) {
    four.changed(map.passable(), part);
    if (eight) eight->changed(map.passable(), part);
    if (prepared) unprepared.insert(unprepared.end(), cells.begin(), cells.end());
    if (colony) colony->changed(part);
    if (holds && !robot_disc && !costs) {
      holds = std::ranges::none_of(
          cells, [this](Cell c) { return map.passable().blocked(c) ? breaks(c) : shortens(c); });
    }
  };
  const EditedMap::OnChange on_edit = [this](const Rectangle& part, std::span<const Cell> cells) {
    if (costs) costs->edited(part);
    holds = holds && !costs;
    if (!robot_disc) return;
    edited.insert(edited.end(), cells.begin(), cells.end());
    if (std::exchange(disc_graph, nullptr)) preparation = {.seconds = preparation.seconds};
    if (costs) return;
    const bool blocked = map.map().blocked(cells[0]);
    if (blocked && !way.path.empty()) {
      wall_rose = true;
    } else {
      holds =
          holds && !blocked && std::ranges::none_of(cells, [this](Cell c) { return shortens(c); });
    }
  };
  /// Does a cell that has become blocked make the way impossible, or the fault another one?
  bool breaks(Cell cell) const noexcept {
    if (way.path.empty())
      return cell == at || cell == goal || cell == way.nearest_free ||
             cell == way.nearest_reachable;
    for (std::size_t i = 1; i < way.path.size(); ++i)
      if (touches(way.path[i - 1], way.path[i], cell)) return true;
    return walker.touches_rest(cell) || beside_walk(cell);
  }
  /// Does the walk pass a cell by a diagonal move?
  bool beside_walk(Cell cell) const noexcept {
    for (std::size_t i = 1; i < way.walk.size(); ++i) {
      const Cell a = way.walk[i - 1], b = way.walk[i];
      if (cell == Cell{a.x, b.y} || cell == Cell{b.x, a.y}) return true;
    }
    return false;
  }

  /// Might a way over a cell that has become free be shorter than what is left of this one? There
  /// is none shorter through it where the straight distances to both ends are as long together.
  bool shortens(Cell cell) const noexcept {
    if (way.path.empty() || ends_short()) return true;
    // Of the cell any point may be met, and of the robot's cell; of a disc any so near to it.
    constexpr double kSlack = 4;
    return distance(at, cell) + distance(cell, goal) <
           way.length + kSlack + (robot_disc ? 2 * options.radius : 0);
  }
  /// Of the goal itself, which cannot be reached.
  bool ends_short() const noexcept { return way.goal_reached && *way.goal_reached != goal; }

  /// What was prepared tells of the map as it is now, as far as it does.
  void note_changes() {
    if (unprepared.empty()) return;
    stale = stale ? StaleAnswers(*stale, map.passable(), unprepared)
                  : StaleAnswers(prepared, map.passable(), unprepared);
    unprepared.clear();
    if (stale->tells()) return;
    stale.reset();
    prepared.reset();
    preparation = {.seconds = preparation.seconds};
  }

  Result ask(Cell robot, const StopCondition& stop) {
    note_changes();
    const PreparedMap* const whole = stale ? nullptr : prepared.get();
    PlanningMap known{
        .grid = map.passable(),
        .graph = whole != nullptr ? whole->graph.get() : nullptr,
        .labels = whole != nullptr ? whole->labels.get() : nullptr,
        .connected = [&](Cell a, Cell b, Corners rule) { return connected(a, b, rule, stop); },
        .disc = robot_disc ? &*robot_disc : nullptr,
        .disc_graph = disc_graph.get(),
        .stale = stale ? &*stale : nullptr,
        .walked = true};
    if (colony) {
      known.search = [&](const Request& request, const Observer& observer) {
        if (colony->goal() != request.goal) send_colony(request.goal);
        return colony->run(request, observer);
      };
    }
    if (costs) {
      known.terrain = &costs->terrain();
      known.search = [&](const Request& request, const Observer&) {
        return costs->run(request, space());
      };
    }
    const Request request{.start = robot,
                          .goal = goal,
                          .stop = stop,
                          .target_gap = options.target_gap,
                          .goal_tolerance = options.goal_tolerance};
    return answer(known, request, options.params, {.workspace = &workspace});
  }

  void take(Result&& result, const StopCondition& stop) {
    static_cast<Result&>(way) = std::move(result);
    way.replanned = true;
    way.walk.clear();
    way.cost = way.walk_cost = kNaN;
    if (costs) return take_walk();
    walker.begin(way.path, robot_disc.has_value());
    if (robot_disc && way.path.size() > 1) walk_over_cells(stop);
    holds = way.status == Status::solved || way.status == Status::unreachable || blocked();
  }
  /// Where no walk follows a disc's path, which passes between centres of cells, the shortest walk
  /// over cells becomes the path; where none leads there, one within the goal's tolerance.
  void walk_over_cells(const StopCondition& stop);
  /// The cell nearest to the goal, within its tolerance, that a walk leads to.
  std::optional<Cell> nearest_walked_to(Cell from, const StopCondition& stop);
  /// Over costs: that of the search.
  void take_walk() {
    holds = way.status == Status::solved || way.status == Status::unreachable || blocked();
    std::vector<Cell> cells;
    if (way.path.size() == 1) cells.assign(1, at);
    if (way.path.size() > 1) cells = costs->walk();
    const auto kept = std::ranges::find(walk, at);
    way.replanned = cells.empty() || !std::equal(cells.begin(), cells.end(), kept, walk.end());
    walk = std::move(cells);
    constexpr std::size_t kMoves = 64;
    way.walk.assign(walk.begin(), walk.begin() + std::min(walk.size(), kMoves));
    if (way.path.empty()) return;
    way.cost = way.path.size() > 1 ? costs->cost() : 0;
    way.walk_cost = way.path.size() > 1 ? costs->walk_cost() : 0;
  }
  bool blocked() const noexcept { return way.status == Status::invalid; }

  void plan(Cell robot, const StopCondition& stop) {
    take(ask(robot, stop), stop);
    if (way.fault == Fault::start_blocked) leave(robot, stop);
  }
  /// The way of a robot that is where it may not be: out first, over what is free on the map.
  void leave(Cell robot, const StopCondition& stop);

  /// The answer of a step that was stopped before it could plan.
  void cut(const StopCondition& stop) {
    Result result;
    end_run(result, stop.poll(), Status::limit);
    take(std::move(result), stop);
  }

  /// The robot went on by the first moves of its walk: what is left of the path begins there, and
  /// is pulled taut as far as that changes it. False where that is to be planned anew.
  bool go_on(std::size_t moves);
  static kernels::HalfPoint halves_of(Point p) noexcept {
    return {static_cast<int>(2 * p.x), static_cast<int>(2 * p.y)};
  }
  /// On its way out a robot is where changes of the grown map tell nothing.
  bool way_out_is_shut() const noexcept {
    return way.way_out && std::any_of(way.walk.begin() + 1, way.walk.end(),
                                      [&](Cell c) { return map.map().blocked(c); });
  }

  /// After some steps without a way, walls that were not observed again are taken for free.
  void doubt(Cell robot, const StopCondition& stop) {
    const bool none = way.path.empty() && (way.status == Status::unreachable || blocked());
    if (!none) return doubts.end_wait();
    const std::vector<Cell> walls = doubts.wait(map.map());
    if (walls.empty()) return;
    map.set(walls, false, on_change, on_edit);
    if (!update_space(stop)) return cut(stop);
    plan(robot, stop);
    way.doubted = static_cast<std::int64_t>(walls.size());
  }

  std::optional<bool> connected(Cell a, Cell b, Corners rule, const StopCondition& stop) {
    const auto joined = four.connected(map.passable(), a, b, stop);
    if (rule != Corners::allow || joined != false) return joined;
    return eight->connected(map.passable(), a, b, stop);
  }

  const Way& step(Cell robot, const StopCondition& stop) {
    way.replanned = false;
    way.doubted = 0;
    const auto here = std::ranges::find(way.walk, robot);
    const bool on_way = way.path.empty() ? robot == at : here != way.walk.end();
    at = robot;
    if (!update_space(stop)) {
      cut(stop);
      return way;
    }
    if (!holds || !on_way || way_out_is_shut() ||
        !(way.path.empty() || go_on(static_cast<std::size_t>(here - way.walk.begin())))) {
      plan(robot, stop);
    } else if (colony && options.search_on && robot != goal && !way.way_out) {
      Result result = ask(robot, stop);
      if (!result.path.empty() && result.length < way.length) take(std::move(result), stop);
    }
    doubt(robot, stop);
    if (!way.path.empty() && way.walk.size() < 2) {
      walker.next(map.passable(), rule_of_walks(corners), robot, way.walk);
      if (way.walk.size() < 2 && robot != goal) holds = false;
    }
    return way;
  }

  Cell goal;
  NavigatorOptions options;
  EditedMap map;
  std::optional<DiscMap> robot_disc;  ///< only where there is a DiscSpace for its radius
  std::vector<Cell> edited;           ///< that its space does not know of
  bool wall_rose = false;             ///< some of them became blocked since the way was looked at
  std::shared_ptr<disc::DiscGraph> disc_graph;
  Doubts doubts{options.doubt_after};
  Corners corners;
  bool taut;  ///< the algorithm's paths are
  std::optional<LiveColony> colony;
  LiveComponents four{map.passable(), Connectivity::four};
  std::optional<LiveComponents> eight;  ///< only where paths may squeeze
  std::shared_ptr<const PreparedMap> prepared;
  std::optional<StaleAnswers> stale;  ///< of that, once cells have changed
  std::vector<Cell> unprepared;       ///< that it does not know of
  Preparation preparation;
  Workspace workspace;
  PathWalker walker;
  TautString string;
  Way way;
  std::optional<LiveCosts> costs;
  std::vector<Cell> walk;  ///< over costs, all of it
  bool holds = false;      ///< the way, as far as is known
  Cell at{-1, -1};         ///< where the robot was in the last step
};

}  // namespace lasius
