// What a folder with a part of a study's runs says of itself.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/options/options.h"

namespace lasius::study {

/// Says in the part's folder that all of its runs are there. @throws Error(output_failed)
void write_part(const tool::StudyCommand& part);

/// The parts whose runs are all in a folder, as they were asked for, in the order of their file
/// names; the study's name is its file's where it lies in the folder, `called` a hash of that.
/// @throws Error(file_missing, file_broken, file_unsupported)
std::vector<tool::StudyCommand> read_parts(const std::filesystem::path& folder);

}  // namespace lasius::study
