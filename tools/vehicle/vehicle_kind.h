// Vehicles as a kind of problem.
#pragma once

#include "tools/command_line/subcommands.h"
#include "tools/console/kinds.h"
#include "tools/options/options.h"

namespace lasius::tool {

const ProblemKind& vehicle_kind();
/// `batch` of a vehicle. The exit code.
int run_vehicle_batch(VehicleCommand command);
Subcommand add_check_path(CLI::App& program);

}  // namespace lasius::tool
