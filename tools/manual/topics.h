// What `lasius help` tells beside the commands.
#pragma once

#include <span>
#include <string_view>

#include "tools/manual/blocks.h"

namespace lasius::tool {

struct Topic {
  std::string_view name, summary;
  Blocks (*blocks)();
  bool in_man_page;  ///< of the program; the others are long, and in its documents
};

std::span<const Topic> topics();

}  // namespace lasius::tool
