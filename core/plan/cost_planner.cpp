#include "lasius/cost_planner.h"

#include <utility>
#include <vector>

#include "core/cost/cost_search.h"
#include "core/loop/run_status.h"
#include "core/params/grid_parameters.h"
#include "core/plan/exact_view.h"
#include "lasius/error.h"
#include "lasius/path.h"

namespace lasius {
namespace {

Planner of_a_point(Planner planner) {
  if (planner.robot().radius == 0) return planner;
  throw Error(ErrorCode::invalid_parameter, "there are costs for a disc",
              "plan for a point, block the cells that a disc cannot enter and add an inflation");
}

}  // namespace

struct CostPlanner::Impl {
  Impl(Planner p, const CostField& costs)
      : planner(of_a_point(std::move(p))),
        terrain(planner.grid(), costs),
        costs_hash(costs.hash()) {}

  Planner planner;
  cost::Terrain terrain;
  std::uint64_t costs_hash;
};

std::optional<double> CostResult::gap() const {
  if (cost == 0) return 0;
  if (path.empty() || !lower_bound || !(*lower_bound > 0)) return std::nullopt;
  return (cost - *lower_bound) / *lower_bound;
}

CostPlanner::CostPlanner(Planner planner, const CostField& costs)
    : impl_(std::make_shared<const Impl>(std::move(planner), costs)) {}
CostPlanner::~CostPlanner() = default;
CostPlanner::CostPlanner(const CostPlanner&) noexcept = default;
CostPlanner& CostPlanner::operator=(const CostPlanner&) noexcept = default;
CostPlanner::CostPlanner(CostPlanner&&) noexcept = default;
CostPlanner& CostPlanner::operator=(CostPlanner&&) noexcept = default;

const Planner& CostPlanner::planner() const noexcept { return impl_->planner; }

CostResult CostPlanner::plan(const Request& request, const CostOptions& options,
                             const Observer& observer) const {
  const cost::Terrain& terrain = impl_->terrain;
  const Params params;  // of exact
  CostResult result;
  Result& plain = result;
  if (options.proof && options.eight_moves) {
    throw Error(ErrorCode::invalid_parameter, "a proof is asked for of eight moves",
                "ask for one of any angle");
  }
  if (terrain.least() == terrain.most() && !options.eight_moves && !options.proof) {
    plain = impl_->planner.plan(request, params, nullptr, observer);
    result.cost = result.length * terrain.least();
    if (result.lower_bound) *result.lower_bound *= terrain.least();
    return result;
  }
  // Start and goal are judged as for `exact`, which has no time to search.
  Request judged = request;
  judged.stop.deadline = Clock::time_point::min();
  judged.stop.time = nullptr;
  plain = impl_->planner.plan(judged, params);
  if (result.status == Status::invalid || result.status == Status::unreachable) return result;
  const Cell goal = result.goal_reached.value_or(request.goal);
  const auto prove = [&](double bound, std::vector<CostProof::Level> levels) {
    if (!options.proof) return;
    result.proof = std::make_shared<const CostProof>(CostProof{.start = request.start,
                                                               .goal = goal,
                                                               .lower_bound = bound,
                                                               .map_hash = planner().grid().hash(),
                                                               .costs_hash = impl_->costs_hash,
                                                               .levels = std::move(levels)});
  };
  if (request.start == goal) {
    result.cost = 0;
    prove(0, {});
    return result;
  }
  const std::optional<Cell> goal_reached = result.goal_reached;
  plain = {};
  plain.goal_reached = goal_reached;
  int improvements = 0;
  const OnImproved show = [&](const std::vector<Point>& path, double cost, double bound) {
    const ExactView view(path, improvements++, cost, bound);
    observer(view);
    return !view.stopped();
  };
  cost::CostSearch search;
  cost::CostAnswer answer;
  std::vector<CostProof::Level> levels;
  if (options.eight_moves) {
    search.search_eight_moves(terrain, request.start, goal, options.corners, request.stop, answer);
  } else {
    const ExactOptions how{.target_gap = request.target_gap,
                           .improved = observer ? &show : nullptr};
    search.search(terrain, request.start, goal, how, request.stop, answer,
                  options.proof ? &levels : nullptr);
  }
  end_run(result, answer.cause, answer.path.empty() ? Status::no_path : Status::solved);
  result.lower_bound = answer.lower_bound;
  result.optimal = answer.optimal;
  if (answer.path.empty()) return result;
  result.path = std::move(answer.path);
  result.length = path_length(result.path);
  result.cost = answer.length;
  prove(answer.lower_bound, std::move(levels));
  return result;
}

}  // namespace lasius
