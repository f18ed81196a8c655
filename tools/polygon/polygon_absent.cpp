#include <nlohmann/json.hpp>

#include "tools/commands.h"
#include "tools/console/exit_code.h"
#include "tools/polygon/polygon_verify.h"

namespace lasius::tool {
namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "this lasius was built without polygon worlds; build it with LASIUS_BUILD_POLYGON=ON (GEOS)");
}

}  // namespace

int run_polygon(const PolygonCommand&) { refuse(); }
int run_world_info(const WorldInfoCommand&) { refuse(); }
Json polygon_replay(const Json&, const std::string&, int, const std::stop_token&) { refuse(); }

}  // namespace lasius::tool
