#include "commands.h"
#include "exit_code.h"

namespace lasius::tool {

namespace {

constexpr const char* kAbsent =
    "this lasius was built without arms; build it with LASIUS_BUILD_ARM=ON (orocos-kdl, urdfdom, "
    "fcl)";

}  // namespace

int run_arm(const ArmCommand&) { throw UsageError(kAbsent); }
int run_arm_study(const StudyCommand&, const std::filesystem::path&) { throw UsageError(kAbsent); }

}  // namespace lasius::tool
