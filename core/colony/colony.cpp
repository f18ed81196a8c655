#include "core/colony/colony.h"

#include "core/colony/islands.h"

namespace lasius {

Result run_colony(const Grid& grid, const Request& request, const Params& params,
                  ColonyMemory& memory, const Observer& observer, const OwnRules& own,
                  const disc::DiscSpace* disc, const cost::Terrain* terrain) {
  if (params.islands > 1)
    return run_islands(grid, request, params, memory, observer, disc, terrain);
  GridColony colony(grid, params, memory, own, GridColony::After::nothing, disc, terrain);
  colony.begin(request);
  return colony.run(request, params.iterations, observer);
}

Result SurvivingColony::run(Cell start, int iterations, const StopCondition& stop,
                            const Observer& observer) {
  // Not to be cut short: a trail in pieces is of no use to the next run.
  if (blank_) colony_.begin({.start = start, .goal = goal_});
  blank_ = false;
  return colony_.run({.start = start, .goal = goal_, .stop = stop}, iterations, observer);
}

}  // namespace lasius
