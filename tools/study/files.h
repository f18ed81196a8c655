// What a study writes.
#pragma once

#include <filesystem>
#include <string>

namespace lasius::study {

/// Makes a folder and those that it lies in. @throws Error(output_failed)
void make_folder(const std::filesystem::path& folder);

/// Writes a file whole or not at all. @throws Error(output_failed)
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace lasius::study
