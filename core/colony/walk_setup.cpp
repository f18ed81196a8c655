#include "core/colony/walk_setup.h"

#include <array>
#include <cmath>
#include <numbers>

#include "kernels/base/power.h"

namespace lasius {
namespace {

/// (1 + turn / 45 degrees)^-beta; 0 straight back, 1 for the first move.
float turn_factor(const kernels::Moves& moves, int previous, int k, double beta) {
  if (previous >= moves.count) return 1;
  const auto from = moves[previous].to, to = moves[k].to;
  const int cross = from.dx * to.dy - from.dy * to.dx, dot = from.dx * to.dx + from.dy * to.dy;
  if (cross == 0 && dot < 0) return 0;
  const double turn = kernels::angle_between(from.dx, from.dy, to.dx, to.dy);
  return static_cast<float>(kernels::power(1 + turn / (std::numbers::pi / 4), -beta));
}

float move_factor(Visibility visibility, const kernels::Moves& moves, int previous, int k,
                  double beta) {
  switch (visibility) {
    case Visibility::none:
      break;
    case Visibility::inverse_step:
      return static_cast<float>(kernels::power(moves[k].length, -beta));
    case Visibility::heading_change:
      return turn_factor(moves, previous, k, beta);
  }
  return 1;
}

}  // namespace

kernels::WalkShape walk_shape(const Params& params, const kernels::Moves& moves, bool mixture) {
  const bool alike = params.visibility == Visibility::inverse_step && moves.count == 4;
  return {.lanes = moves.count,
          .mixture = mixture,
          .factor = params.visibility != Visibility::none && !alike,
          .draw = params.selection == Selection::roulette ? kernels::Draw::roulette
                                                          : kernels::Draw::discard};
}

kernels::WalkWorld walk_world(const Params& params, const kernels::Moves& moves, Cell start,
                              Cell goal) {
  kernels::WalkWorld world;
  for (int k = 0; k < moves.count; ++k) world.set_move(k, moves[k].to);
  world.start = kernels::pack(start.x, start.y);
  world.goal = kernels::pack(goal.x, goal.y);
  world.backtrack = params.dead_end == DeadEnd::backtrack;
  world.seed = params.seed;
  return world;
}

void set_iteration(kernels::WalkWorld& world, const Params& params, const kernels::Moves& moves,
                   const kernels::WalkShape& shape, const StepWeights& weights, int iteration) {
  world.iteration = static_cast<std::uint32_t>(iteration);
  const double drawn = weights.pheromone_rule + weights.distance_rule + weights.combined_rule;
  const auto of_drawn = [&](double rule) { return rule / drawn * (1 - weights.greedy); };
  std::array<double, kernels::kRules> shares{};
  shares[kernels::kGreedyRule] = weights.greedy;
  shares[kernels::kPheromoneRule] = of_drawn(weights.pheromone_rule);
  shares[kernels::kDistanceRule] = of_drawn(weights.distance_rule);
  shares[kernels::kCombinedRule] = of_drawn(weights.combined_rule);
  double before = 0;
  for (int r = 0; r < kernels::kRules; ++r) {
    const double share = shares[r];
    world.rule_start[r] = static_cast<std::uint64_t>(std::ceil(before * 0x1p32));
    world.rule_scale[r] = share > 0 ? static_cast<float>(1 / (share * 0x1p32)) : 0.0f;
    before += share;
  }
  if (!shape.factor) return;
  for (int previous = 0; previous <= kernels::kMaxMoves; ++previous) {
    for (int k = 0; k < moves.count; ++k) {
      world.factor[previous][k] = move_factor(params.visibility, moves, previous, k, weights.beta);
    }
  }
}

}  // namespace lasius
