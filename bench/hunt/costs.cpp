// Cheapest paths over weights.
#include <algorithm>

#include "bench/hunt/drawing.h"
#include "bench/peers/weighted_map.h"
#include "lasius/cost/planner.h"
#include "tests/oracle/cost_paths.h"

namespace lasius::bench {
namespace {

std::vector<double> draw_weights(HuntDraw& draw, const Grid& grid) {
  std::vector<double> weights(static_cast<std::size_t>(grid.width()) * grid.height());
  const int kind = draw.between(0, 3);
  const double uniform = draw.real(0.5, 4);
  for (double& w : weights)
    w = kind == 0   ? uniform
        : kind == 1 ? draw.between(1, 3)
        : kind == 2 ? draw.real(0.1, 9)
                    : (draw.one_in(8) ? 200 : 1);
  return weights;
}

}  // namespace

void judge_costs(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  const Grid& grid = problem.grid;
  const std::vector<double> weights = draw_weights(draw, grid);
  const double most = std::ranges::max(weights);
  const CostField costs(grid.width(), grid.height(), weights);
  const CostPlanner planner(Planner(Grid(grid)), costs);
  const peers::WeightedMap map(grid, costs);
  peers::PathIntegral judge(map);
  const Cell from = problem.places[0], to = problem.places[1];
  // Points on each edge of a cell: some path's cost, so no bound may be above it.
  const int points = draw.between(1, 3);
  const double reached = oracle::cost_over_points(
      grid, [&](Cell c) { return costs.weight(c); }, centre(from), centre(to), points);
  Request request{.start = from, .goal = to};
  if (draw.one_in(3)) request.target_gap = draw.real(0.001, 0.1);

  const auto expect = [&](std::string_view who, const CostResult& got, bool any_angle) {
    if (std::isinf(reached)) {
      verdict.expect(got.status == Status::unreachable && got.path.empty(),
                     [&] { return sentence(who, ": a path where there is none"); });
      return;
    }
    const double cost = judge.of(got.path);
    // The judge leaves out what is shorter than 1e-9 cells of a piece.
    const double slack = 1e-9 * static_cast<double>(got.path.size()) * most;
    verdict.expect(!got.path.empty() &&
                       (same_length(cost, got.cost) || std::abs(cost - got.cost) <= slack) &&
                       got.lower_bound.value_or(0) <= got.cost * (1 + 1e-9),
                   [&] { return sentence(who, ": cost ", got.cost, " of a path of ", cost); });
    const double limit = any_angle ? reached : got.cost;
    verdict.expect(got.lower_bound.value_or(0) <= limit * (1 + 1e-9), [&] {
      return sentence(who, ": bound ", *got.lower_bound, " above a path of ", reached);
    });
    if (request.target_gap > 0 && any_angle)
      verdict.expect(got.gap().value_or(1) <= request.target_gap * (1 + 1e-9),
                     [&] { return sentence(who, ": gap ", got.gap().value_or(1)); });
  };
  const CostResult best = planner.plan(request);
  expect("exact", best, true);
  if (request.target_gap > 0) return;
  CostOptions moves;
  moves.eight_moves = true;
  const CostResult walk = planner.plan(request, moves);
  expect("eight moves", walk, false);
  if (!walk.path.empty() && !best.path.empty())
    verdict.expect(best.cost <= walk.cost * (1 + 1e-9) &&
                       best.lower_bound.value_or(0) <= walk.cost * (1 + 1e-9),
                   [&] { return std::string("dearer than eight moves"); });
  CostOptions ants;
  ants.params = Params("mmas");
  ants.params.iterations = draw.between(1, 4);
  ants.params.seed = draw.any() >> 12;
  const CostResult colony = planner.plan(request, ants);
  if (!colony.path.empty()) expect("colony", colony, true);
}

}  // namespace lasius::bench
