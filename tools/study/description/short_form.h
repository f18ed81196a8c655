// `lasius study run`: a study without a file.
#pragma once

#include <string>

#include "tools/options/options.h"
#include "tools/study/study.h"

namespace lasius::study {

/// The study as the text of a file, with `seeds` unless there are 0 of them: every algorithm at
/// every combination of values. @throws tool::UsageError for a name that is not UTF-8.
std::string study_text(const tool::ShortStudy& run, const Seeds& seeds);

}  // namespace lasius::study
