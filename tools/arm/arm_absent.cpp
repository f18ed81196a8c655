#include <nlohmann/json.hpp>

#include "tools/arm/arm_verify.h"
#include "tools/commands.h"
#include "tools/console/exit_code.h"

namespace lasius::tool {
namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "this lasius was built without arms; build it with LASIUS_BUILD_ARM=ON (orocos-kdl, urdfdom, "
      "fcl)");
}

}  // namespace

int run_arm(const ArmCommand&) { refuse(); }
int run_arm_study(const StudyCommand&, const std::filesystem::path&) { refuse(); }
Json arm_replay(const Json&, const std::string&, const std::string&, int, const std::stop_token&) {
  refuse();
}

}  // namespace lasius::tool
