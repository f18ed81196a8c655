// Pictures of a run: map, tracks, pheromone, path and convergence on one page.
#pragma once

#include <string>
#include <vector>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// Panels: the tracks at the chosen iterations, the pheromone, the path on the map, and the
/// convergence; only the path for algorithms without iterations. `recorder` may be null.
void write_plan_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                        const Answer& answer, const PictureRecorder* recorder);

/// All paths of a batch on the map.
void write_batch_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                         const std::vector<std::vector<Point>>& paths);

}  // namespace lasius::tool
