// What results on bitmaps record of their inputs, and how it is read back.
#pragma once

#include "tools/bitmap/map_file.h"
#include "tools/options/options.h"
#include "tools/record/problem.h"

namespace lasius::tool {

/// {file, hash, width, height}
Json map_json(const LoadedMap& map);

/// [x, y] of a start or goal, whole.
Json cell_json(const Place& place);

/// Of the "parameters": what was done to the map.
void add_map_settings(Json& json, const LoadedMap& map, Frame frame);

/// The question that a result answers. @throws UsageError, Error
PlanCommand recorded_plan(const Recorded& from);

}  // namespace lasius::tool
