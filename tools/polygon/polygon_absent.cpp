#include "tools/console/exit_code.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_task.h"

namespace lasius::tool {
namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "this lasius was built without polygon worlds; build it with LASIUS_BUILD_POLYGON=ON (GEOS)");
}

}  // namespace

int run_command(const PolygonCommand&) { refuse(); }
int run_command(const PolygonBatchCommand&) { refuse(); }
int run_command(const WorldInfoCommand&) { refuse(); }
std::unique_ptr<Task> recorded_polygon(const Recorded&, SharedWorld&) { refuse(); }

}  // namespace lasius::tool
