// Scenarios and tables of queries: read, or refused by an Error that names the line.
#include <cmath>

#include "tests/fuzz/reading.h"
#include "tools/record/queries.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lasius;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const bool whole : {true, false}) {
    std::istringstream in(bytes);
    try {
      const auto file = tool::read_queries(in, "fuzz", 10, 6, whole);
      for (const auto& query : file.queries)
        for (const double value : {query.start.x, query.start.y, query.goal.x, query.goal.y})
          fuzz::require(std::isfinite(value));
    } catch (const Error& error) {
      fuzz::require(error.code() == ErrorCode::file_broken && error.place().file == "fuzz");
      fuzz::require(error.place().line >= 1 && !error.remedy().empty());
    }
  }
  return 0;
}
