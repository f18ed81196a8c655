// The colony on a bitmap: what the one loop asks of it, composed from parameters.
#pragma once

#include "lasius/planner.h"

namespace lasius {

/// Runs the colony that `params` composes from `request.start` to `request.goal`, which are free,
/// joined and not equal.
Result run_colony(const Grid& grid, const Request& request, const Params& params,
                  Workspace::Impl& workspace, const Observer& observer);

}  // namespace lasius
