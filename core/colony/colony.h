// The colony on a bitmap: what the one loop asks of it, composed from parameters.
#pragma once

#include "core/colony/colony_memory.h"
#include "lasius/params.h"
#include "lasius/progress.h"
#include "lasius/request.h"
#include "lasius/result.h"

namespace lasius {

/// Runs the colony that `params` composes from `request.start` to `request.goal`, which are free,
/// joined and not equal.
Result run_colony(const Grid& grid, const Request& request, const Params& params,
                  ColonyMemory& memory, const Observer& observer);

}  // namespace lasius
