// Motions of arms as a kind of problem.
#pragma once

#include "tools/command_line/subcommands.h"
#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& arm_kind();
Subcommand add_arm(CLI::App& program);

}  // namespace lasius::tool
