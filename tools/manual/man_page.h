// Blocks as a manual page.
#pragma once

#include <string>
#include <string_view>

#include "tools/manual/blocks.h"

namespace lasius::tool {

/// Blocks in the macros of man(7).
std::string roff(const Blocks& blocks);

/// The page NAME(1): its first lines, up to the synopsis, of which `usage` is a line each.
std::string roff_title(std::string_view name, std::string_view summary, std::string_view date,
                       const std::vector<std::string>& usage);

}  // namespace lasius::tool
