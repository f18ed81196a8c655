#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/invalid_parameter.h"
#include "core/colony/own_update.h"
#include "core/cost/cost_search.h"
#include "core/cost/merged.h"
#include "core/cost/path_cost.h"
#include "core/disc/disc_search.h"
#include "core/grid/components.h"
#include "core/grid/distance.h"
#include "core/loop/run_status.h"
#include "core/plan/cost_paths.h"
#include "core/plan/legs.h"
#include "core/plan/plan_ends.h"
#include "core/plan/planner_impl.h"
#include "lasius/cost/planner.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

using cost::CostAnswer;
using cost::Terrain;

/// @throws Error(invalid_parameter) where `exact` cannot do all that is asked for at once.
void check_asked(const CostOptions& options, bool disc) {
  if (options.proof && options.eight_moves)
    refuse("a proof is asked for of eight moves", "ask for one of any angle");
  if (options.eight_moves && options.corners == Corners::allow)
    refuse("corners of eight moves are allow",
           "use forbid or one_side: walks over costs squeeze nowhere");
  if (disc && (options.proof || options.eight_moves))
    refuse(options.proof ? "a proof is asked for of a disc" : "eight moves of a disc are asked for",
           "ask for paths of any angle alone, or plan for a point");
}

}  // namespace

struct CostPlanner::Impl {
  Impl(Planner p, const DiscMap* disc, const CostField& costs)
      : planner(std::move(p)),
        space(space_of(disc)),
        terrain(space != nullptr ? space->blocked_cells() : planner.grid(), costs),
        costs_hash(costs.hash()) {
    if (space != nullptr) whole.emplace(planner.grid(), costs);
  }

  /// What the searches of one request have in common.
  struct Run {
    const Request& request;
    Cell goal;
    const CostOptions& options;
    Kept& kept;
    double proven = kInfinity;  ///< where not all cells are searched: the bound of all
    std::vector<CostProof::Level> levels = {};
  };
  CostAnswer search(const Terrain& over, Run& run) const;
  CostAnswer search_for_disc(Run& run) const;
  bool uniform() const noexcept { return terrain.least() == terrain.most(); }
  CostResult shortest(const Request& request) const;
  CostResult over_uniform(const Request& request, const CostOptions& options) const;
  bool join_ends(const Request& between, const Asked& start, const Asked& goal,
                 CostResult& result) const;
  CostResult colony(const Planner::Impl& map, const Request& request,
                    const CostOptions& options) const;
  std::shared_ptr<const CostProof> proof(Run& run, double bound) const;
  std::shared_ptr<const CostProof> proof_of_centres(Request request, Cell goal,
                                                    const CostOptions& options) const;

  Planner planner;
  const disc::DiscSpace* space;       ///< of `planner`; null for a point
  Terrain terrain;                    ///< of a disc the cells that have a clear point
  std::optional<Terrain> whole = {};  ///< of a disc: where it may have to be led out of, too
  std::uint64_t costs_hash;
};

CostAnswer CostPlanner::Impl::search(const Terrain& over, Run& run) const {
  const Request& request = run.request;
  cost::CostSearch search;
  CostAnswer answer;
  const OnImproved improved = [&](const std::vector<Point>& path, double cost, double bound) {
    return run.kept.offer(path, cost, std::min(bound, run.proven));
  };
  if (run.options.eight_moves) {
    search.search_eight_moves(over, request.start, run.goal, run.options.corners, request.stop,
                              answer);
    if (!answer.path.empty()) run.kept.offer(answer.path, answer.length, answer.lower_bound);
    return answer;
  }
  const auto within = [](const std::optional<Point>& point, Cell c) {
    return point ? Point{point->x - c.x, point->y - c.y} : cost::kMiddle;
  };
  const ExactOptions how{.target_gap = request.target_gap, .improved = &improved};
  const auto goal_point = run.goal == request.goal ? request.goal_point : std::nullopt;
  search.search(over,
                {request.start, run.goal, within(request.start_point, request.start),
                 within(goal_point, run.goal)},
                how, request.stop, answer, run.options.proof ? &run.levels : nullptr);
  return answer;
}

// The bound is that of the cells that have a clear point. Where their cheapest path does not keep
// the radius it is led round, and where that costs much another is looked for.
CostAnswer CostPlanner::Impl::search_for_disc(Run& run) const {
  constexpr double kMuch = 1e-3;  // of the cost
  const auto offer = [&](const std::vector<Point>& path, double bound) {
    if (!path.empty()) run.kept.offer(path, cost::cost_of(terrain, path), bound);
  };
  const StopCondition& stop = run.request.stop;
  Request direct = run.request;
  direct.goal_tolerance = direct.target_gap = 0;
  if (std::exchange(direct.goal, run.goal) != run.goal) direct.goal_point = std::nullopt;
  offer(planner.plan(direct).path, 0);
  CostAnswer answer = search(terrain, run);
  if (answer.end == ExactEnd::stopped) return answer;
  offer(repaired(*space, answer.path, stop), answer.lower_bound);
  if (run.kept.cost() <= answer.lower_bound * (1 + std::max(kMuch, run.request.target_gap)))
    return answer;
  const Grid cells = wide_cells(*space, planner.passable(), run.request.start, run.goal);
  const auto regions = Components::make(cells, Components::Connectivity::four, stop);
  if (!regions || !regions->connected(cells, run.request.start, run.goal)) return answer;
  run.proven = answer.lower_bound;
  CostAnswer wide = search(narrowed(terrain, cells), run);
  offer(repaired(*space, wide.path, stop), answer.lower_bound);
  wide.lower_bound = answer.lower_bound;
  return wide;
}

// Polylines of a colony over costs may be a whole disc's, led out first.
CostResult CostPlanner::Impl::colony(const Planner::Impl& map, const Request& request,
                                     const CostOptions& options) const {
  const Params& params = options.params;
  if (find_algorithm(params.algorithm()).kind != Algorithm::Kind::colony)
    refuse(std::string(params.algorithm()) + " plans by length alone",
           "take exact or a colony over costs");
  if (corners_of_paths(params, planner.robot()) == Corners::allow)
    refuse("corners is allow, and paths over costs squeeze nowhere", "use forbid or one-side");
  if (options.proof || options.eight_moves)
    refuse("a proof or eight moves are asked for of a colony", "take exact");
  PlanningMap planning = map.planning_map(request.stop);
  planning.terrain = &terrain;
  CostResult result;
  static_cast<Result&>(result) = answer(planning, request, params,
                                        {.workspace = options.workspace,
                                         .observer = options.observer,
                                         .own_rules = options.own_rules});
  if (!result.path.empty())
    result.cost = cost::cost_of(space != nullptr ? *whole : terrain, result.path);
  return result;
}

std::shared_ptr<const CostProof> CostPlanner::Impl::proof(Run& run, double bound) const {
  if (!run.options.proof) return nullptr;
  return std::make_shared<const CostProof>(CostProof{.start = run.request.start,
                                                     .goal = run.goal,
                                                     .lower_bound = bound,
                                                     .map_hash = planner.grid().hash(),
                                                     .costs_hash = costs_hash,
                                                     .levels = std::move(run.levels)});
}

// By a search for itself, beside the one for the answer.
std::shared_ptr<const CostProof> CostPlanner::Impl::proof_of_centres(
    Request request, Cell goal, const CostOptions& options) const {
  request.start_point = request.goal_point = std::nullopt;
  const Observer none;
  Kept found(terrain, space, none);
  Run run{request, goal, options, found};
  return proof(run, request.start == goal ? 0 : search(terrain, run).lower_bound);
}

// It begins or ends beside the centres of cells: the shortest path, which costs what it costs.
CostResult CostPlanner::Impl::shortest(const Request& request) const {
  CostResult result;
  static_cast<Result&>(result) = planner.plan(request);
  result.optimal = false;
  if (result.lower_bound) *result.lower_bound *= terrain.least();
  result.curve.clear();
  if (result.path.empty()) return result;
  result.length = path_length(result.path);
  result.cost = cost::cost_of(*whole, result.path);
  return result;
}

// Every cell costs the same: the shortest path is the cheapest.
CostResult CostPlanner::Impl::over_uniform(const Request& request,
                                           const CostOptions& options) const {
  CostResult result;
  static_cast<Result&>(result) = planner.plan(request, {}, {.observer = options.observer});
  result.cost = result.length * terrain.least();
  if (result.lower_bound) *result.lower_bound *= terrain.least();
  if (!options.proof || result.path.empty()) return result;
  result.proof = proof_of_centres(request, result.goal_reached.value_or(request.goal), options);
  return result;
}

// A path between points inside cells is led on to those that were asked for. False where a disc
// cannot go so.
bool CostPlanner::Impl::join_ends(const Request& between, const Asked& start, const Asked& goal,
                                  CostResult& result) const {
  std::vector<Point>& path = result.path;
  if (start.at == goal.at && start.is_point) {
    path = {start.at};
    result.cost = result.length = 0;
    result.lower_bound = 0;
    return result.optimal = true;
  }
  double less = 0;
  const auto put = [&](Point from, Point to) {
    if (path.front() != from) return;  // a goal's tolerance leads elsewhere
    less += cost::cost_of(terrain, std::array{from, to});
    move_end(path, to);
  };
  put(*between.start_point, start.at);
  std::ranges::reverse(path);
  put(*between.goal_point, goal.at);
  std::ranges::reverse(path);
  if (const auto fewer = cost::merged(terrain, path); can_go(space, fewer)) path = fewer;
  if (!can_go(space, path)) return false;
  result.cost = cost::cost_of(terrain, path);
  result.length = path_length(path);
  if (!result.lower_bound) return true;
  const double straight =
      (whole ? *whole : terrain).least() / (1 + 1e-12) * distance(path.front(), path.back());
  result.lower_bound = std::min(std::max(straight, *result.lower_bound - less), result.cost);
  result.optimal = result.cost - *result.lower_bound <= 1e-9 * result.cost;
  return true;
}

std::optional<double> CostResult::gap() const {
  if (cost == 0) return 0;
  if (path.empty() || !lower_bound || !(*lower_bound > 0)) return std::nullopt;
  return (cost - *lower_bound) / *lower_bound;
}

CostPlanner::CostPlanner(Planner planner, const CostField& costs) {
  const DiscMap* const disc = planner.impl_->disc.get();
  if (disc != nullptr && !disc->space) disc::check_disc_radius(disc->radius);
  impl_ = std::make_shared<const Impl>(std::move(planner), disc, costs);
}
CostPlanner::~CostPlanner() = default;
CostPlanner::CostPlanner(const CostPlanner&) noexcept = default;
CostPlanner& CostPlanner::operator=(const CostPlanner&) noexcept = default;
CostPlanner::CostPlanner(CostPlanner&&) noexcept = default;
CostPlanner& CostPlanner::operator=(CostPlanner&&) noexcept = default;

const Planner& CostPlanner::planner() const noexcept { return impl_->planner; }
double CostPlanner::least_weight() const noexcept {
  return (impl_->whole ? *impl_->whole : impl_->terrain).least();
}

// Searches go from a point inside a cell to another: one on its border is moved inside, a colony's
// to its centre. What a straight piece there costs is taken off the bound.
CostResult CostPlanner::plan(const Request& asked, const CostOptions& options) const {
  if (asked.alternatives != 0)
    refuse("alternatives are asked for over costs",
           "ask a Planner: they are ways beside a shortest path");
  if (!asked.via.empty()) return plan_through(asked, options);
  const Grid& grid = planner().grid();
  const Asked start(grid, asked.start, asked.start_point);
  const Asked goal(grid, asked.goal, asked.goal_point);
  const bool exact = find_algorithm(options.params.algorithm()).kind == Algorithm::Kind::exact;
  const bool centres = !exact || options.eight_moves;
  if (exact) check_asked(options, impl_->space != nullptr);
  if (!centres && !options.proof && impl_->uniform()) return plan_cells(asked, options);
  Request request = asked;
  request.start = start.cell;
  request.goal = goal.cell;
  request.start_point = request.goal_point = std::nullopt;
  if (!start.is_point && !goal.is_point) return plan_cells(request, options);
  std::vector<std::pair<Cell, Cell>> sides;
  if (impl_->space == nullptr) {
    const PlanningMap map = planner().impl_->planning_map(asked.stop);
    const Ends ends(map, nullptr, corners_of_paths(options.params, {}));
    if (ends.serves(start) && ends.serves(goal)) {
      std::tie(request.start, request.goal) = ends.walk(start.at, goal.at);
      for (const Cell from : begun_in(impl_->terrain, ends.walked_from(start.at)))
        for (const Cell to : begun_in(impl_->terrain, ends.walked_from(goal.at)))
          if (!centres && map.connected(from, to, Corners::forbid) == true)
            sides.emplace_back(from, to);
    }
  }
  if (sides.empty()) sides.emplace_back(request.start, request.goal);
  if (exact && options.proof) {  // a proof is of centres
    CostOptions unproven = options;
    unproven.proof = false;
    Request first = asked;  // half of the time is the proof's
    const auto now = asked.stop.now();
    if (asked.stop.deadline > now && asked.stop.deadline < Clock::time_point::max())
      first.stop.deadline = now + (asked.stop.deadline - now) / 2;
    CostResult result = plan(first, unproven);
    if (!result.path.empty() && grid.free(request.start))
      result.proof =
          impl_->proof_of_centres(request, result.goal_reached.value_or(request.goal), options);
    return result;
  }
  const disc::DiscSpace* const space = impl_->space;
  const auto leads = [&](const Asked& end, Point to) {
    return space->clear(end.at) && space->clear(to) && space->reaches(end.at, to);
  };
  const auto plan_side = [&](const std::pair<Cell, Cell>& side, const CostOptions& how) {
    std::tie(request.start, request.goal) = side;
    request.start_point = inside(request.start, start.at, centres);
    request.goal_point = inside(request.goal, goal.at, centres);
    const bool moved = request.start_point != start.at || request.goal_point != goal.at;
    if (space != nullptr && moved) {
      if (exact && !(leads(start, *request.start_point) && leads(goal, *request.goal_point)))
        return impl_->shortest(asked);
      if (!exact)
        refuse("a colony over costs is asked for a disc between points that are no cells' centres",
               "take exact, or cells");
    }
    CostResult result = plan_cells(request, how);
    if (result.path.empty() || !moved) return result;
    return impl_->join_ends(request, start, goal, result) ? result : impl_->shortest(asked);
  };
  CostResult result = plan_side(sides.front(), options);
  CostOptions silent = options;  // one search tells of better and better paths
  silent.observer = {};
  for (const auto& side : std::span(sides).subspan(1))
    result = cheaper(std::move(result), plan_side(side, silent));
  return result;
}

CostResult CostPlanner::plan_cells(const Request& request, const CostOptions& options) const {
  const Terrain& terrain = impl_->terrain;
  const bool disc = impl_->space != nullptr;
  if (find_algorithm(options.params.algorithm()).kind != Algorithm::Kind::exact)
    return impl_->colony(*impl_->planner.impl_, request, options);
  if (impl_->uniform() && !options.eight_moves) return impl_->over_uniform(request, options);
  CostResult result;
  Result& plain = result;
  // Start and goal are judged as for `exact`, which has no time to search.
  Request judged = request;
  judged.stop.deadline = Clock::time_point::min();
  judged.stop.time = nullptr;
  plain = impl_->planner.plan(judged);
  if (result.status == Status::invalid || result.status == Status::unreachable) return result;
  const Cell goal = result.goal_reached.value_or(request.goal);
  const Point from = request.start_point.value_or(centre(request.start));
  const Point to = goal == request.goal ? request.goal_point.value_or(centre(goal)) : centre(goal);
  if (disc && (result.way_out || !impl_->space->clear(to))) return impl_->shortest(request);
  Kept kept(terrain, impl_->space, options.observer);
  Impl::Run run{request, goal, options, kept};
  if (request.start == goal) {
    const auto straight = from == to ? std::vector{from} : std::vector{from, to};
    const double length = path_length(straight), cost = cost::cost_of(terrain, straight);
    const double bound = terrain.least() * length;
    if (cost <= bound && can_go(impl_->space, straight)) {  // else it may be cheaper around
      result.status = Status::solved;
      result.limit = Limit::none;
      result.path = straight;
      result.length = length;
      result.cost = cost;
      result.lower_bound = bound;
      result.optimal = true;
      result.proof = impl_->proof(run, 0);
      return result;
    }
  }
  const std::optional<Cell> goal_reached = result.goal_reached;
  plain = {};
  plain.goal_reached = goal_reached;
  const CostAnswer answer = disc ? impl_->search_for_disc(run) : impl_->search(terrain, run);
  end_run(result, answer.cause, kept.any() ? Status::solved : Status::no_path);
  result.lower_bound = answer.lower_bound;
  if (!kept.any()) return result;
  result.path = std::move(kept.path());
  result.length = path_length(result.path);
  result.cost = kept.cost();
  result.lower_bound = std::min(answer.lower_bound, result.cost);
  result.optimal = result.cost - *result.lower_bound <= 1e-9 * result.cost;
  result.proof = impl_->proof(run, *result.lower_bound);
  return result;
}

}  // namespace lasius
