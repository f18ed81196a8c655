// Convergence plots and path pictures of a study.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/draw/line_chart.h"
#include "tools/study/findings.h"
#include "tools/study/markdown.h"

namespace lasius::study {

/// Each question is drawn: unless charts show all of them, or there are too many contenders.
bool draws_questions(const Experiment& experiment);

/// The samples of a question that have runs: what is drawn.
std::vector<const Sample*> drawn(const Findings& findings, const Experiment& experiment,
                                 const Question& question);

/// The shortest run; null where none has a path.
const Run* best_run(const Sample& sample);

/// The best so far of each contender, and the run lengths where the optimum is known and a run
/// comes near it; nothing where there is no course to draw, as of runs of one iteration.
std::vector<tool::LineChart> convergence_charts(const Study& study, const Findings& findings,
                                                const Experiment& experiment,
                                                const Question& question);

/// Best and mean tours of some contenders over all questions.
std::vector<tool::LineChart> contender_charts(const Study& study, const Findings& findings,
                                              const Experiment& experiment,
                                              const std::vector<std::string>& contenders);

/// Draws, for every question of every experiment, the convergence, the run lengths and on bitmaps
/// the best path of each contender, or the experiment's own charts, into `folder`/pictures as SVG
/// and PNG. Returns the figures in the order of the page.
std::vector<Figure> draw_pictures(const Study& study, const Findings& findings,
                                  const std::filesystem::path& folder,
                                  const std::filesystem::path& maps);

}  // namespace lasius::study
