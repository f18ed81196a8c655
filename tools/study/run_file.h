// One file a run, so that a study can stop anywhere and go on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/study/findings.h"

namespace lasius::study {

/// The run in a file; nothing where there is no file, it is broken, or its key, its seed or the
/// version of the library differ.
std::optional<Run> read_run(const std::filesystem::path& file, const std::string& key,
                            std::uint64_t seed);

/// The same of its text.
std::optional<Run> parse_run(const std::string& text, const std::string& key, std::uint64_t seed);

/// Whole or not at all. @throws Error(output_failed).
void write_run(const std::filesystem::path& file, const std::string& key, const Run& run);

/// What a run's file holds, a line.
std::string run_text(const std::string& key, const Run& run);

}  // namespace lasius::study
