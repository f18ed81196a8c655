// What plan and batch say before they start.
#pragma once

#include "tools/bitmap/map_file.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// Says what has no effect, and with -v what was read.
void announce(const PreparedMap& map, const RunOptions& run);

}  // namespace lasius::tool
