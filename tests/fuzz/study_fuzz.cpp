// Files of studies: read, or refused by an Error that names the line.
#include "tests/fuzz/reading.h"
#include "tools/study/description/study_file.h"

namespace lasius::fuzz {

void check(const std::string& text) {
  try {
    const study::Study study = study::parse_study(text, "fuzz");
    require(!study.experiments.empty());
    for (const study::Experiment& e : study.experiments)
      require(!e.contenders.empty() && !e.questions.empty() && !e.targets.empty());
  } catch (const Error& error) {
    require(error.code() == ErrorCode::file_broken || error.code() == ErrorCode::file_missing);
    require(error.place().line >= 1 || error.code() == ErrorCode::file_missing);
    require(!error.problem().empty() && !error.remedy().empty());
  }
}

}  // namespace lasius::fuzz
