#include "tools/arm/arm_task.h"
#include "tools/console/exit_code.h"
#include "tools/options/commands.h"

namespace lasius::tool {
namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "this lasius was built without arms; build it with LASIUS_BUILD_ARM=ON (orocos-kdl, urdfdom, "
      "fcl)");
}

}  // namespace

int run_command(const ArmCommand&) { refuse(); }
std::unique_ptr<Task> recorded_arm(const Recorded&) { refuse(); }

}  // namespace lasius::tool
