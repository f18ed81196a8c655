#include "tools/console/kinds.h"

#include <algorithm>

#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"

namespace lasius::tool {

std::string_view algorithm_of(const ProblemKind& kind, std::string_view name) {
  if (name.empty()) return kind.algorithms.front().name;
  const auto has = [&](const ProblemKind& one) {
    return std::ranges::find(one.algorithms, name, &Algorithm::name) != one.algorithms.end();
  };
  if (!has(kind))
    for (const ProblemKind* other : kinds())
      if (has(*other))
        throw UsageError(std::string("--algorithm: ")
                             .append(name)
                             .append(" plans ")
                             .append(other->plans)
                             .append(other->detail)
                             .append(", not ")
                             .append(kind.plans)
                             .append(other->advice));
  const auto known = names_of(kind.algorithms);
  return known[choice_value("--algorithm", name, known)];
}

bool is_polygon_file(std::string_view file) {
  return std::ranges::any_of(kPolygonFileEndings,
                             [&](std::string_view ending) { return has_ending(file, ending); });
}

}  // namespace lasius::tool
