#include "core/loop/colony_loop.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/thread_team.h"

namespace lasius {
namespace {

double arrived_with(double length) { return length > 0 ? length : kNaN; }

/// The main loop.
StopCondition::Cause loop(ColonyWorld& world, int iterations, const StopCondition& stop,
                          Convergence& run) {
  for (int q = 0; q < iterations; ++q) {
    auto cause = world.send_ants(q);
    if (cause != StopCondition::Cause::none) {
      world.offer_cut();
      return cause;
    }
    world.offer();
    world.update_trail(q);
    record(sums_of(world), run);
    cause = world.observe(run);
    if (world.settled() || q + 1 == iterations) break;
    if (cause == StopCondition::Cause::none) cause = stop.poll();
    if (cause != StopCondition::Cause::none) return cause;
  }
  return StopCondition::Cause::none;
}

}  // namespace

IterationSums::Values IterationSums::Values::of(double value) {
  if (std::isnan(value)) return {};
  return {value, value, 1};
}

void IterationSums::Values::add(const Values& more) {
  sum += more.sum;
  least = std::fmin(least, more.least);
  count += more.count;
}

void IterationSums::add(const IterationSums& more) {
  raw.add(more.raw);
  cut.add(more.cut);
  entropies.add(more.entropies);
  best = std::fmin(best, more.best);
  iteration_best = std::fmin(iteration_best, more.iteration_best);
  steps += more.steps;
  cells += more.cells;
  near += more.near;
  walked = walked || more.walked;
}

IterationSums sums_of(const ColonyWorld& world) {
  using Values = IterationSums::Values;
  IterationSums sums;
  for (int a = 0; a < world.ants(); ++a) {
    sums.raw.add(Values::of(arrived_with(world.tour_length(a))));
    const auto walked = world.walked(a);
    if (!walked) continue;
    sums.walked = true;
    sums.cut.add(Values::of(arrived_with(walked->cut_length)));
    sums.steps += walked->steps;
    sums.cells += walked->cells;
    sums.near += walked->near;
  }
  sums.best = world.best_length();
  if (!sums.walked) return sums;
  sums.iteration_best = world.iteration_best();
  sums.entropies = Values::of(world.trail_entropy());
  return sums;
}

void add_part(std::vector<IterationSums>& to, std::span<const IterationSums> part) {
  const auto keep = [](std::span<const IterationSums> from) {
    IterationSums left;
    if (!from.empty()) left.best = from.back().best;
    return left;
  };
  const IterationSums own = keep(to), others = keep(part);
  to.resize(std::max(to.size(), part.size()), own);
  for (std::size_t q = 0; q < to.size(); ++q) to[q].add(q < part.size() ? part[q] : others);
}

void record(const IterationSums& sums, Convergence& run) {
  run.best.push_back(sums.best);
  run.mean.push_back(sums.raw.mean());
  run.arrived.push_back(sums.raw.count);
  if (sums.walked) {
    run.raw_best.push_back(sums.raw.least);
    run.cut_mean.push_back(sums.cut.mean());
    run.cut_best.push_back(sums.cut.least);
    run.iteration_best.push_back(sums.iteration_best);
    run.steps.push_back(sums.steps);
    run.band.push_back(
        sums.cells > 0 ? static_cast<double>(sums.near) / static_cast<double>(sums.cells) : kNaN);
    run.trail_entropy.push_back(sums.entropies.mean());
  }
  ++run.iterations;
}

StopCondition::Cause run_colony_loop(ColonyWorld& world, int iterations, const StopCondition& stop,
                                     Convergence& run) {
  auto cause = stop.poll();  // before threads are woken
  if (cause != StopCondition::Cause::none) return cause;
  const auto run_loop = [&] { cause = loop(world, iterations, stop, run); };
  ThreadTeam::lead(world.threads(), std::ref(run_loop));  // a reference: nothing is allocated
  return cause;
}

}  // namespace lasius
