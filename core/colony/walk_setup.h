// What the walk kernel reads, made from a colony's parameters.
#pragma once

#include "kernels/base/moves.h"
#include "kernels/walk/walk.h"
#include "lasius/grid/geometry.h"
#include "lasius/params/params.h"
#include "lasius/params/schedule.h"

namespace lasius {

/// Which kernel walks. `mixture` says what rows hold, see Field.
kernels::WalkShape walk_shape(const Params& params, const kernels::Moves& moves, bool mixture);

/// The world of an ant, but for the rows of weights and what set_iteration() enters.
kernels::WalkWorld walk_world(const Params& params, const kernels::Moves& moves, Cell start,
                              Cell goal);

/// Hands an iteration's shares of the rules and factors of the moves to the walk.
void set_iteration(kernels::WalkWorld& world, const Params& params, const kernels::Moves& moves,
                   const kernels::WalkShape& shape, const StepWeights& weights, int iteration);

}  // namespace lasius
