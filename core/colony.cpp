#include "colony.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "kernel_choice.h"
#include "kernels/power.h"
#include "lasius/path.h"
#include "polish.h"
#include "schedule.h"
#include "workspace.h"

namespace lasius {
namespace {

using kernels::WalkWorld;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Length of a tour: counts are exact, so the sum does not depend on the order of the moves.
double tour_length(const Ant& ant, const kernels::Moves& moves) {
  std::int64_t diagonal = 0;
  for (std::int64_t i = 0; i < ant.move_count; ++i) {
    const int k = ant.moves[i];
    diagonal += moves.dx[k] != 0 && moves.dy[k] != 0;
  }
  return static_cast<double>(ant.move_count - diagonal) +
         static_cast<double>(diagonal) * std::numbers::sqrt2;
}

class Colony final : public Progress {
 public:
  Colony(const Grid& grid, const Request& request, const Params& params, Workspace::Impl& workspace)
      : grid_(grid),
        request_(request),
        params_(params),
        ws_(workspace),
        threads_(thread_count(params)),
        moves_(kernels::moves_of(params.neighbours)) {
    ws_.field.reset(grid, moves_, request.goal, params);
    ws_.walkers.reset(grid.width(), grid.height(), threads_, params.ants);
    ws_.polisher.reset(params, threads_);
    ws_.ants.resize(params.ants);
    shape_ = {.lanes = moves_.count,
              .mixture = ws_.field.mixture(),
              .factor = params.visibility != Visibility::none && moves_.count > 4};
    kernel_ = kernels::walk_table(chosen_isa()).walk[shape_.index()];
    world_ = make_world();
  }

  /// The main loop.
  Result run(const Observer& observer) {
    auto cause = StopCondition::Cause::none;
    for (int q = 0; q < params_.iterations; ++q) {
      const StepWeights weights = schedule(params_, q);
      ws_.field.refresh(weights, threads_);
      apply(weights, q);
      for (Ant& ant : ws_.ants) ant.arrived = false;
      cause = ws_.walkers.walk(world_, kernel_, ws_.ants, request_.stop);
      ws_.polisher.polish(grid_, request_.start, moves_, ws_.ants, request_.stop);
      const bool improved = offer();
      if (cause == StopCondition::Cause::none) cause = request_.stop.poll();
      if (cause != StopCondition::Cause::none) break;
      lay_trails(improved);
      record(q);
      if (observer) observer(*this);
    }
    return answer(cause);
  }

  // What an observer sees.
  int ants() const override { return params_.ants; }
  std::vector<Cell> tour(int ant) const override {
    std::vector<Cell> cells;
    if (ws_.ants.at(ant).arrived) tour_cells(ws_.ants[ant], moves_, request_.start, cells);
    return cells;
  }
  double pheromone(Cell c) const override { return ws_.field.pheromone(c); }

 private:
  WalkWorld make_world() {
    WalkWorld world;
    for (int k = 0; k < moves_.count; ++k) world.delta[k] = moves_.dy[k] * 65536 + moves_.dx[k];
    world.start = kernels::pack(request_.start.x, request_.start.y);
    world.goal = kernels::pack(request_.goal.x, request_.goal.y);
    world.backtrack = params_.dead_end == DeadEnd::backtrack;
    world.seed = params_.seed;
    for (auto& row : world.factor) row.fill(1);
    return world;
  }

  /// Hands an iteration's weights to the walk.
  void apply(const StepWeights& weights, int q) {
    ws_.field.fill(world_);
    world_.iteration = static_cast<std::uint32_t>(q);
    double total = 0;
    for (const double share : weights.rule_shares) total += share;
    double before = 0;
    for (int r = 0; r < kernels::kRules; ++r) {
      const double share = weights.rule_shares[r] / total * 0x1p32;
      world_.rule_start[r] = static_cast<std::uint64_t>(std::ceil(before));
      world_.rule_scale[r] = share > 0 ? static_cast<float>(1 / share) : 0.0f;
      before += share;
    }
    if (shape_.factor) {
      const auto diagonal = static_cast<float>(kernels::power(std::numbers::sqrt2, -weights.beta));
      for (auto& row : world_.factor) {
        for (int k = 0; k < moves_.count; ++k) {
          row[k] = moves_.dx[k] != 0 && moves_.dy[k] != 0 ? diagonal : 1.0f;
        }
      }
    }
  }

  /// Offers every ant's path as the best one, ties to the lower index. True if one was better.
  bool offer() {
    const auto paths = ws_.polisher.paths();
    int best = -1;
    for (int a = 0; a < params_.ants; ++a) {
      if (paths[a].length < (best < 0 ? best_length_ : paths[best].length)) best = a;
    }
    improving_ant_ = best;
    if (best < 0) return false;
    best_length_ = paths[best].length;
    best_path_ = paths[best].points;
    return true;
  }

  /// Evaporation, then Q / L on each tour, then on each straightened path (Fan et al. 2004, steps
  /// 2 and 3); always in the order of the ants.
  void lay_trails(bool improved) {
    ws_.field.evaporate(params_.persistence);
    for (int a = 0; a < params_.ants; ++a) {
      const Ant& ant = ws_.ants[a];
      if (!ant.arrived) continue;
      const double amount = params_.deposit / tour_length(ant, moves_);
      Cell c = request_.start;
      if (params_.trail == Trail::cells) ws_.field.deposit(c, 0, amount);
      for (std::int64_t i = 0; i < ant.move_count; ++i) {
        const int k = ant.moves[i];
        if (params_.trail == Trail::arcs) ws_.field.deposit(c, k, amount);
        c = {c.x + moves_.dx[k], c.y + moves_.dy[k]};
        if (params_.trail == Trail::cells) ws_.field.deposit(c, 0, amount);
      }
    }
    for (int a = 0; a < params_.ants; ++a) {
      const bool laid = params_.straight_deposit == StraightDeposit::all ||
                        (params_.straight_deposit == StraightDeposit::improving && improved &&
                         a == improving_ant_);
      const PolishedPath& path = ws_.polisher.paths()[a];
      if (!laid || !ws_.ants[a].arrived) continue;
      for (const Cell c : path.raster) ws_.field.deposit(c, 0, params_.deposit / path.length);
    }
  }

  void record(int q) {
    double sum = 0;
    int count = 0;
    for (const Ant& ant : ws_.ants) {
      if (!ant.arrived) continue;
      sum += tour_length(ant, moves_);
      ++count;
    }
    iteration = q;
    arrived = count;
    mean_length = count > 0 ? sum / count : kNaN;
    best_length = best_length_ < kInfinity ? best_length_ : kNaN;
    result_.best.push_back(best_length);
    result_.mean.push_back(mean_length);
    result_.arrived.push_back(arrived);
    result_.iterations = q + 1;
  }

  Result answer(StopCondition::Cause cause) {
    const bool found = best_length_ < kInfinity;
    switch (cause) {
      case StopCondition::Cause::none:
        result_.status = found ? Status::solved : Status::no_path;
        break;
      case StopCondition::Cause::deadline:
        result_.status = Status::limit;
        break;
      case StopCondition::Cause::token:
        result_.status = Status::interrupted;
        break;
    }
    if (found) {
      result_.path = std::move(best_path_);
      result_.length = path_length(result_.path);
    }
    return std::move(result_);
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  const Grid& grid_;
  const Request& request_;
  const Params& params_;
  Workspace::Impl& ws_;
  int threads_;
  kernels::Moves moves_;
  kernels::WalkShape shape_;
  kernels::WalkFn kernel_ = nullptr;
  WalkWorld world_;

  double best_length_ = kInfinity;
  int improving_ant_ = -1;
  std::vector<Point> best_path_;
  Result result_;
};

}  // namespace

Result run_colony(const Grid& grid, const Request& request, const Params& params,
                  Workspace::Impl& workspace, const Observer& observer) {
  return Colony(grid, request, params, workspace).run(observer);
}

}  // namespace lasius
