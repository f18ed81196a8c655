// Paths among polygons as a kind of problem.
#pragma once

#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& polygon_kind();

}  // namespace lasius::tool
