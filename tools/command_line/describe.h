// The commands and their options as data, read off CLI11's tables.
#pragma once

#include <vector>

#include "tools/command_line/subcommands.h"
#include "tools/options/manual.h"

namespace lasius::tool {

Manual describe(const CLI::App& app, const std::vector<Subcommand>& commands);

}  // namespace lasius::tool
