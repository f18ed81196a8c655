// Pictures of a run: map, tracks, pheromone, path and convergence on one page.
#pragma once

#include <string>
#include <vector>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// Panels: of a colony the tracks of the chosen iterations, alone and up to them, and the pheromone
/// or terminal index; the path on the map, and the convergence. Only what there is: the path alone
/// for algorithms without iterations. `recorder` may be null. A border without free cells is left
/// out, and that is said.
void write_plan_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                        const Answer& answer, const PictureRecorder* recorder);

/// All paths of a batch on the map, none of them empty.
void write_batch_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                         const std::vector<std::vector<Point>>& paths, const std::string& caption);

}  // namespace lasius::tool
