// Pictures of single runs: what the colony did, not only what it found.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/study/markdown.h"
#include "tools/study/study.h"

namespace lasius::study {

/// Runs the first contender with seed 1 on the questions of the experiments that ask for it, and
/// draws tracks, pheromone, path and convergence; or a dead end, a success and the tours ant by
/// ant. A contender that the library does not have is left out.
std::vector<Figure> draw_portraits(const Study& study, const std::filesystem::path& folder,
                                   const std::filesystem::path& maps);

}  // namespace lasius::study
