// Tours as a kind of problem.
#pragma once

#include "tools/command_line/subcommands.h"
#include "tools/console/kinds.h"

namespace lasius::tool {

const ProblemKind& tour_kind();
Subcommand add_tour(CLI::App& program);

/// By the ending: a problem of TSPLIB, .tsp or .sop.
bool is_tsplib(std::string_view file);

}  // namespace lasius::tool
