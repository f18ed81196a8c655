// Motions of arms as a kind of problem.
#pragma once

#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& arm_kind();

}  // namespace lasius::tool
