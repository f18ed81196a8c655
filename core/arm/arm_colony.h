// The colony of `goritov2020`, in the common loop.
#pragma once

#include "core/arm/lattice.h"
#include "lasius/arm/plan.h"

namespace lasius::arm {

/// Sends ants through the lattice until the run ends. Precondition: the arm can stand at the start,
/// which is not the goal; kinematics reaches the goal; `parameters` are valid, with a number of
/// threads.
Result run_arm_colony(Lattice& lattice, const Request& request, const Params& parameters,
                      const Observer& observer);

}  // namespace lasius::arm
