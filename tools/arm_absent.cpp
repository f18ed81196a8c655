#include "commands.h"
#include "exit_code.h"

namespace lasius::tool {

int run_arm(const ArmCommand&) {
  throw UsageError(
      "this lasius was built without arms; build it with LASIUS_BUILD_ARM=ON (orocos-kdl, urdfdom, "
      "fcl)");
}

}  // namespace lasius::tool
