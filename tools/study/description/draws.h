// Questions whose starts and goals are drawn.
#pragma once

#include <filesystem>

#include "tools/study/study.h"

namespace lasius::study {

/// Puts so many questions, NAME-1 and so on, in place of each that asks for a draw: of cells that
/// are joined and at least so far apart. Other questions have to lie on free cells of their map.
/// The same study and maps give the same questions. Precondition: the study is of bitmaps.
/// @throws Error(file_broken) naming the line where a question lies outside or on a blocked cell,
/// or no such pair was found; what load_map throws.
void draw_questions(Study& study, const std::filesystem::path& maps);

}  // namespace lasius::study
