// A path over costs with fewer vertices.
#pragma once

#include <vector>

#include "core/cost/terrain.h"

namespace lasius::cost {

/// The path without the vertices that are nearly (within 1e-6 cells) on a straight line between two
/// others, where the straight way is allowed and costs no more.
std::vector<Point> merged(const Terrain& terrain, const std::vector<Point>& path);

}  // namespace lasius::cost
