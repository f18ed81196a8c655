#include "core/colony/colony.h"

#include "core/colony/grid_colony.h"
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

struct SurvivingColony::Impl {
  Impl(const Grid& on, Cell to, const Params& p, const disc::DiscSpace* disc)
      : goal(to),
        params(p),
        colony(on, params, memory, no_own_rules(), GridColony::After::more_runs, disc) {}

  Cell goal;
  Params params;
  ColonyMemory memory;
  GridColony colony;
  bool blank = true;
};

SurvivingColony::SurvivingColony(const Grid& grid, Cell goal, const Params& params,
                                 const disc::DiscSpace* disc)
    : impl_(std::make_unique<Impl>(grid, goal, params, disc)) {}
SurvivingColony::~SurvivingColony() = default;

Result SurvivingColony::run(Cell start, int iterations, const StopCondition& stop,
                            const Observer& observer) {
  GridColony& colony = impl_->colony;
  // Not to be cut short: a trail in pieces is of no use to the next run.
  if (impl_->blank) colony.begin({.start = start, .goal = impl_->goal});
  impl_->blank = false;
  return colony.run({.start = start, .goal = impl_->goal, .stop = stop}, iterations, observer);
}

void SurvivingColony::changed(const Rectangle& part) {
  if (!impl_->blank) impl_->colony.changed(part);
}

void SurvivingColony::forget() { impl_->blank = true; }

}  // namespace lasius
