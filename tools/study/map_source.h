// Where a question's map comes from.
#pragma once

#include <filesystem>
#include <string>

#include "lasius/grid.h"

namespace lasius::study {

/// A file of `folder`, or a generated map: "random WxH DENSITY SEED" with any kind of `lasius
/// generate`. @throws Error for a missing or broken file, or a map that cannot be made.
Grid load_map(const std::string& source, const std::filesystem::path& folder);

/// True for a map that is generated.
bool is_generated(const std::string& source);

}  // namespace lasius::study
