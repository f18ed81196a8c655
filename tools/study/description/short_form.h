// `lasius study run`: a study without a file.
#pragma once

#include <string>

#include "tools/options/options.h"

namespace lasius::study {

/// The file that says the same: every algorithm at every combination of values.
std::string study_text(const tool::ShortStudy& run);

}  // namespace lasius::study
