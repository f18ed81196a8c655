#include "tools/console/exit_code.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_kind.h"
#include "tools/record/problem.h"

namespace lasius::tool {
namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "this lasius was built without polygon worlds; build it with LASIUS_BUILD_POLYGON=ON (GEOS)");
}

}  // namespace

int run_command(const PolygonCommand&) { refuse(); }
int run_command(const WorldInfoCommand&) { refuse(); }

const ProblemKind& polygon_kind() {
  static const ProblemKind kKind{
      .commands = {"plan", "batch"},
      .takes = is_polygon_file,
      .format = kPlanFormat,
      .wrote =
          [](const Json& json) { return is_polygon_file(json["map"]["file"].get<std::string>()); },
      .again = [](const Recorded&, const Problem*) -> std::unique_ptr<Problem> { refuse(); }};
  return kKind;
}

}  // namespace lasius::tool
