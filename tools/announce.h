// What plan and batch say before they start.
#pragma once

#include "map_file.h"
#include "options.h"

namespace lasius::tool {

/// Says what has no effect, and with -v what was read.
void announce(const PreparedMap& map, const RunOptions& run);

}  // namespace lasius::tool
