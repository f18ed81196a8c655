// Files of studies: read, or refused by an Error that names the line.
#include "tests/fuzz/reading.h"
#include "tools/study/description/study_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lasius;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const study::Study study = study::parse_study(text, "fuzz");
    fuzz::require(!study.experiments.empty());
    for (const study::Experiment& e : study.experiments)
      fuzz::require(!e.contenders.empty() && !e.questions.empty() && !e.targets.empty());
  } catch (const Error& error) {
    fuzz::require(error.code() == ErrorCode::file_broken ||
                  error.code() == ErrorCode::file_missing);
    fuzz::require(error.place().line >= 1 || error.code() == ErrorCode::file_missing);
    fuzz::require(!error.problem().empty() && !error.remedy().empty());
  }
  return 0;
}
