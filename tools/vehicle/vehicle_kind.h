// Vehicles as a kind of problem.
#pragma once

#include "tools/command_line/subcommands.h"
#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& vehicle_kind();
Subcommand add_check_path(CLI::App& program);

}  // namespace lasius::tool
