// What a tuning writes.
#pragma once

#include <string>

#include "tools/study/table.h"
#include "tools/study/tune/tuning.h"

namespace lasius::study {

/// What the judgement on other maps says, in a line.
std::string verdict_text(const Tuning& tuning, const Tuned& tuned);

/// The winner, or the best so far, as `--preset FILE` takes it.
std::string preset_text(const Tuning& tuning, const Tuned& tuned);

/// Every candidate: its parameters, how far it came, and by which test it left.
Table candidate_table(const Tuning& tuning, const Tuned& tuned);

/// The race's runs, a row each.
Table race_table(const Tuned& tuned);

/// The report as a Markdown page.
std::string tune_page(const Tuning& tuning, const Tuned& tuned);

}  // namespace lasius::study
