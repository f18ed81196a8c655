#include "tools/arm/arm_command.h"
#include "tools/arm/arm_kind.h"
#include "tools/console/exit_code.h"
#include "tools/record/problem.h"

namespace lasius::tool {
namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "this lasius was built without arms; build it with LASIUS_BUILD_ARM=ON (orocos-kdl, "
      "urdfdom)");
}

}  // namespace

int run_command(const ArmCommand&) { refuse(); }

const ProblemKind& arm_kind() {
  static const ProblemKind kKind{
      .commands = {"arm"},
      .format = kArmFormat,
      .again = [](const Recorded&, const Problem*) -> std::unique_ptr<Problem> { refuse(); }};
  return kKind;
}

}  // namespace lasius::tool
