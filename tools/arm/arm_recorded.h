// The question of a saved result of `lasius arm`.
#pragma once

#include "tools/record/problem.h"

namespace lasius::tool {

/// @throws UsageError for what is missing or no such value.
ArmCommand recorded_command(const Recorded& recorded);

}  // namespace lasius::tool
