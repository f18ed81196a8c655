// What there is: a line a kind of problem, a line a command.
#include "tools/console/kinds.h"

#include "tools/arm/arm_kind.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/command_line/subcommands.h"
#include "tools/drive/drive_kind.h"
#include "tools/polygon/polygon_kind.h"
#include "tools/tour/tour_kind.h"
#include "tools/vehicle/vehicle_kind.h"

namespace lasius::tool {

std::span<const ProblemKind* const> kinds() {
  static const ProblemKind* const kAll[] = {&bitmap_kind(),  &drive_kind(), &arm_kind(),
                                            &polygon_kind(), &tour_kind(),  &vehicle_kind()};
  return kAll;
}

std::vector<AddSubcommand> subcommands() {
  return {add_plan,       add_drive,    add_tour,   add_batch,      add_info,
          add_algorithms, add_generate, add_verify, add_check_path, add_check_proof,
          add_merge,      add_study,    add_tune,   add_arm,        add_help};
}

}  // namespace lasius::tool
