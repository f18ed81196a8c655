// Scenarios and tables of queries: read, or refused by an Error that names the line.
#include <cmath>

#include "tests/fuzz/reading.h"
#include "tools/record/queries.h"

namespace lasius::fuzz {

void check(const std::string& bytes) {
  for (const bool whole : {true, false}) {
    std::istringstream in(bytes);
    try {
      const auto file = tool::read_queries(in, "fuzz", 10, 6, whole);
      for (const auto& query : file.queries)
        for (const double value : {query.start.x, query.start.y, query.goal.x, query.goal.y})
          require(std::isfinite(value));
    } catch (const Error& error) {
      require(error.code() == ErrorCode::file_broken && error.place().file == "fuzz");
      require(error.place().line >= 1 && !error.remedy().empty());
    }
  }
}

}  // namespace lasius::fuzz
