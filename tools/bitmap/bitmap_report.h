// The page of a run on a bitmap.
#pragma once

#include <iosfwd>
#include <vector>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/run_frames.h"
#include "tools/record/record.h"

namespace lasius::tool {

/// The walls of a part of a map: {width, height, shares}, a byte a pixel, packed.
Json walls_json(const Grid& grid, const Window& window);

/// What a page shows of a map: {width, height, window [x, y, width, height], walls {width, height,
/// shares}, resolution and to_world [6 numbers: x and y of metres by column, row and 1] or null}.
Json map_view_json(const LoadedMap& map, const Window& window);

/// {step, values} of clearance_along; null without a path.
Json clearance_json(const Grid& grid, const std::vector<Point>& path, double length);

/// `frames` may be null.
void write_bitmap_report(std::ostream& out, const Record& record, const LoadedMap& map,
                         const RunOptions& run, const Answer& answer, const RunFrames* frames);

}  // namespace lasius::tool
