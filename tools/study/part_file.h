// What a folder with a part of a study's runs says of itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/options/options.h"

namespace lasius::study {

/// The file of `study run`, in its folder.
inline constexpr const char* kShortStudy = "study.yaml";

/// A part as it was asked for.
struct StudyPart {
  tool::StudyCommand command;
  std::string hash;  ///< of the study's file, where it has one
};

/// Says in the part's folder that all of its runs are there. @throws Error(output_failed)
void write_part(const tool::StudyCommand& part);

/// The parts whose runs are all in a folder, in the order of their file names.
/// @throws Error(file_missing, file_broken, file_unsupported)
std::vector<StudyPart> read_parts(const std::filesystem::path& folder);

}  // namespace lasius::study
