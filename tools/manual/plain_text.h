// Blocks as text for a terminal of 80 columns.
#pragma once

#include <string>

#include "tools/manual/blocks.h"

namespace lasius::tool {

std::string plain_text(const Blocks& blocks);

}  // namespace lasius::tool
