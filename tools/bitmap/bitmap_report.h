// The page of a run on a bitmap.
#pragma once

#include <iosfwd>
#include <vector>

#include "tools/bitmap/map_file.h"
#include "tools/bitmap/run_frames.h"
#include "tools/record/task.h"

namespace lasius::tool {

/// What a page shows of a map: {width, height, window [x, y, width, height], walls {width, height,
/// shares}, resolution and to_world [6 numbers: x and y of metres by column, row and 1] or null}.
Json map_view_json(const LoadedMap& map, const Window& window);

/// How far points of a path, evenly spread over it, are from the nearest blocked cell or the edge:
/// {step, values}. Farther than kMostClearance counts as that.
inline constexpr int kMostClearance = 64;
Json clearance_json(const Grid& grid, const std::vector<Point>& path, double length);

/// Distance from a point to the nearest blocked cell's square or the outside, at most `most`.
double distance_to_blocked(const Grid& grid, Point at, int most);

/// `frames` may be null.
void write_bitmap_report(std::ostream& out, const Task& task, const LoadedMap& map,
                         const RunOptions& run, const std::vector<Cell>& ends,
                         const std::vector<Point>& path, const RunFrames* frames);

}  // namespace lasius::tool
