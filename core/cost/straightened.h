// A walk over costs with straight pieces in it.
#pragma once

#include <span>
#include <vector>

#include "core/cost/polish.h"
#include "core/cost/terrain.h"

namespace lasius::cost {

/// A walk by eight moves as the pieces of a path that goes straight from one cell's centre to a
/// later one's, as far on as that costs no more than the walk; O(length * its logarithm). What
/// Polish begins with, which would take long to straighten a walk.
std::vector<Leg> straightened(const Terrain& terrain, std::span<const Cell> walk);

}  // namespace lasius::cost
