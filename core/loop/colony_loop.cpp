#include "core/loop/colony_loop.h"

#include "core/base/thread_team.h"

namespace lasius {
namespace {

void record(const ColonyWorld& world, Convergence& run) {
  double sum = 0;
  int arrived = 0;
  for (int a = 0; a < world.ants(); ++a) {
    const double length = world.tour_length(a);
    if (!(length > 0)) continue;
    sum += length;
    ++arrived;
  }
  run.best.push_back(world.best_length());
  run.mean.push_back(arrived > 0 ? sum / arrived : kNaN);
  run.arrived.push_back(arrived);
  ++run.iterations;
}

/// The main loop.
StopCondition::Cause loop(ColonyWorld& world, int iterations, const StopCondition& stop,
                          Convergence& run) {
  auto cause = StopCondition::Cause::none;
  for (int q = 0; q < iterations && cause == StopCondition::Cause::none; ++q) {
    cause = world.send_ants(q);
    world.offer();
    if (cause == StopCondition::Cause::none) cause = stop.poll();
    if (cause != StopCondition::Cause::none) break;
    world.update(q);
    cause = stop.poll();
    if (cause != StopCondition::Cause::none) break;
    record(world, run);
    cause = world.observe(run);
    if (world.settled()) break;
  }
  return cause;
}

}  // namespace

StopCondition::Cause run_colony_loop(ColonyWorld& world, int iterations, const StopCondition& stop,
                                     Convergence& run) {
  auto cause = stop.poll();  // before threads are woken
  if (cause != StopCondition::Cause::none) return cause;
  ThreadTeam::lead(world.threads(), [&] { cause = loop(world, iterations, stop, run); });
  return cause;
}

}  // namespace lasius
