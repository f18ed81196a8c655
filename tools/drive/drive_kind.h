// Drives as a kind of problem.
#pragma once

#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& drive_kind();

}  // namespace lasius::tool
