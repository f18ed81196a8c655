// One question answered, with all that a result records.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "lasius/cost/planner.h"
#include "lasius/plan/batch.h"
#include "lasius/plan/planner.h"
#include "tools/bitmap/reasons.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// All that a plan on a map was asked and found.
struct Answer {
  Place start{};
  Place goal{};
  Result result{};
  double elapsed_ms = 0;  ///< of the plan; the map's preparation is not in it
  /// With --gap: exact shortest length, where one exists and was found in time; over costs what
  /// `exact` finds, whose bound is then that of `over_costs`.
  std::optional<double> optimum{};
  /// With --gap: the shortest by the algorithm's own moves, any angle for `exact`.
  std::optional<double> grid_optimum{};
  std::optional<Remedy> remedy{};                  ///< where the ends are not joined
  std::optional<CostResult> over_costs{};          ///< `result` with what it has beside
  std::shared_ptr<const CostProof> shown_proof{};  ///< whose lines pictures and pages show
};

/// @throws UsageError for a radius in metres that the algorithm does not serve, which tells them.
/// What was given in cells the library refuses.
void check_radius(const LoadedMap& map, const RunOptions& run);

/// A point of an answer in metres of the map's frame: where it is one that was asked for in metres,
/// the numbers that were given.
Point in_metres(const LoadedMap& map, const RunOptions& run, const Answer& answer, Point at);

/// Where a path ends that does not reach the goal asked for.
std::optional<Point> short_end(const Answer& answer);

/// How the algorithm goes about on a map with a planner.
Route route_of(const LoadedMap& map, const RunOptions& run);
/// Looks for what would join ends that are not; also of two centres of free cells, one of which is
/// too near to what is blocked, and the nearest free cell does not lead to the other.
void set_remedy(LoadedMap& map, const RunOptions& run, const std::stop_token& token,
                Answer& answer);
/// Is the run of a colony whose islands the ranks of a crew send together? Pictures of ants are of
/// one process.
bool shares_islands(const RunOptions& run);
/// The question, without what ends it.
Request request_of(const LoadedMap& map, const RunOptions& run, const Place& start,
                   const Place& goal);

/// Plans; a radius that is refused is told in metres where it was given so.
void in_metres_asked(const LoadedMap& map, const RunOptions& run,
                     const std::function<void()>& plan);

/// How a run plans over costs.
CostOptions cost_options(const RunOptions& run, const Observer& observer = {});
/// A path's cost, and how far above the least it is at most.
std::string cost_text(const CostResult& result);
/// What --gap asks for of a colony over costs: `exact`'s answer to the same question.
CostResult least_cost(const LoadedMap& map, const RunOptions& run, Request request,
                      const StopCondition& stop);
/// Certifies an answer over costs by the bound of least_cost().
void set_least_cost(Answer& answer, const CostResult& least);
/// Makes an answer of one over costs.
void set_costs(Answer& answer, const CostResult& found);

/// Plans from `start` to `goal` under `stop`, with a crew whose islands are shared on all its
/// ranks, of which one goes on; then looks for --gap's optima under the token and, each, as long a
/// limit again.
Answer answer(const LoadedMap& map, const RunOptions& run, const Place& start, const Place& goal,
              const StopCondition& stop, const Observer& observer = {});

/// Length of the shortest walk by the moves of the run's algorithm, if there is one and it is found
/// in time. Precondition: the algorithm is not `exact`.
std::optional<double> shortest_by_own_moves(const LoadedMap& map, const RunOptions& run,
                                            const Request& query, const StopCondition& stop);

/// The gap of the shortest walk found, after the cut and before polish, to the optimum of the
/// algorithm's own moves. None where no ant has arrived, or the optimum is not known.
std::optional<double> grid_gap(const Answer& answer, const Params& params);

/// Fills in what --gap asks for, from the shortest path of all and, of an algorithm that moves on
/// cells, the shortest walk by its own moves, as far as they are known.
void set_optima(const RunOptions& run, std::optional<double> any_angle,
                std::optional<double> by_moves, Answer& answer);

/// Params of the exact planner for a run.
Params optimum_params(const RunOptions& run);

}  // namespace lasius::tool
