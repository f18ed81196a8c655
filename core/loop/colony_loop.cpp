#include "core/loop/colony_loop.h"

#include <algorithm>
#include <functional>

#include "core/base/thread_team.h"

namespace lasius {
namespace {

/// Mean and least of lengths; not numbers where there were none.
class Lengths {
 public:
  void add(double length) {
    if (!(length > 0)) return;
    sum_ += length;
    least_ = ++count_ == 1 ? length : std::min(least_, length);
  }
  int count() const { return count_; }
  double mean() const { return count_ > 0 ? sum_ / count_ : kNaN; }
  double least() const { return least_; }

 private:
  double sum_ = 0, least_ = kNaN;
  int count_ = 0;
};

void record(const ColonyWorld& world, Convergence& run) {
  Lengths raw, cut;
  std::optional<std::int64_t> steps;
  std::int64_t cells = 0, near = 0;
  for (int a = 0; a < world.ants(); ++a) {
    raw.add(world.tour_length(a));
    const auto walked = world.walked(a);
    if (!walked) continue;
    cut.add(walked->cut_length);
    steps = steps.value_or(0) + walked->steps;
    cells += walked->cells;
    near += walked->near;
  }
  run.best.push_back(world.best_length());
  run.mean.push_back(raw.mean());
  run.arrived.push_back(raw.count());
  if (steps) {
    run.raw_best.push_back(raw.least());
    run.cut_mean.push_back(cut.mean());
    run.cut_best.push_back(cut.least());
    run.iteration_best.push_back(world.iteration_best());
    run.steps.push_back(*steps);
    run.band.push_back(cells > 0 ? static_cast<double>(near) / static_cast<double>(cells) : kNaN);
    run.trail_entropy.push_back(world.trail_entropy());
  }
  ++run.iterations;
}

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
    record(world, run);
    cause = world.observe(run);
    if (world.settled() || q + 1 == iterations) break;
    if (cause == StopCondition::Cause::none) cause = stop.poll();
    if (cause != StopCondition::Cause::none) return cause;
  }
  return StopCondition::Cause::none;
}

}  // namespace

StopCondition::Cause run_colony_loop(ColonyWorld& world, int iterations, const StopCondition& stop,
                                     Convergence& run) {
  auto cause = stop.poll();  // before threads are woken
  if (cause != StopCondition::Cause::none) return cause;
  const auto run_loop = [&] { cause = loop(world, iterations, stop, run); };
  ThreadTeam::lead(world.threads(), std::ref(run_loop));  // a reference: nothing is allocated
  return cause;
}

}  // namespace lasius
