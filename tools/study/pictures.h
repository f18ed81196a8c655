// Convergence plots and path pictures of a study.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/study/findings.h"
#include "tools/study/markdown.h"

namespace lasius::study {

/// Draws, for every question of every experiment, the convergence, the run lengths and on bitmaps
/// the best path of each contender, or the experiment's own charts, into `folder`/pictures as SVG
/// and PNG. Returns the figures in the order of the page.
std::vector<Figure> draw_pictures(const Study& study, const Findings& findings,
                                  const std::filesystem::path& folder,
                                  const std::filesystem::path& maps);

}  // namespace lasius::study
