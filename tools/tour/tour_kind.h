// Tours as a kind of problem.
#pragma once

#include <string>
#include <vector>

#include "tools/command_line/subcommands.h"
#include "tools/console/kinds.h"

namespace lasius::tool {

class OptionTable;
struct TourCommand;
struct VehicleCommand;

const ProblemKind& tour_kind();
Subcommand add_tour(CLI::App& program);

/// By the ending: a problem of TSPLIB, .tsp or .sop.
bool is_tsplib(std::string_view file);

/// What drives, and from where to where. @throws UsageError for what is of points and discs
void take_vehicle(const OptionTable& table, TourCommand& tour, const VehicleCommand& vehicle,
                  const std::vector<std::string>& starts, const std::string& goal);

}  // namespace lasius::tool
