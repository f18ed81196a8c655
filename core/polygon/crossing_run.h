// One run over the crossing points of one line sequence: by a colony, or by the genetic algorithm.
#pragma once

#include <functional>

#include "core/loop/colony_loop.h"
#include "core/polygon/route.h"
#include "lasius/polygon/plan.h"

namespace lasius::polygon {

/// What a run of one sequence left.
struct CrossingRun {
  Crossing best;
  Convergence curves;
  StopCondition::Cause cause = StopCondition::Cause::none;
};

/// How a run is asked to end, and who looks on.
struct RunControl {
  StopCondition stop;
  double good_enough = 0;  ///< ends at a path of this length
  /// Gets the curves and what makes the best path so far; says whether to stop.
  std::function<StopCondition::Cause(const Convergence&, const std::function<Crossing()>& best)>
      observe;
};

/// `maklink-acs` (the lecture, E2): ant colony system on `values` points of each gate. All ants
/// advance in lock-step, gate by gate and ant by ant within a gate; the local update follows right
/// after every choice. `start` is Dijkstra's path: its values are the first h*, it is what is kept
/// until an ant does better. Precondition of both: the route has a gate.
CrossingRun run_crossing_colony(const Route& route, const Crossing& start, const Params& parameters,
                                const RunControl& control);

/// `real-ga` (the lecture's comparator, E3): chromosomes (h_1 .. h_d) in [0, 1]^d. The source names
/// the coding, elitist selection, 50 chromosomes, crossover 0.6, mutation 0.05 and a "crossover
/// constant" whose value is lost. Taken here: parents by binary tournament; arithmetic crossover,
/// child = (1 - c) one + c other with c = `blend`; a mutated gene is drawn anew; children and
/// parents together, the fittest live on. An iteration is a generation, its "ants" the children.
CrossingRun run_crossing_ga(const Route& route, const Crossing& start, const Params& parameters,
                            const RunControl& control);

}  // namespace lasius::polygon
