// Drives as a kind of problem.
#pragma once

#include "tools/command_line/subcommands.h"
#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& drive_kind();
Subcommand add_drive(CLI::App& program);

}  // namespace lasius::tool
