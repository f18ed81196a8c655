// The little Markdown that our documents are written in, as blocks.
#pragma once

#include <string_view>

#include "tools/manual/blocks.h"

namespace lasius::tool {

/// What stands below a heading of `page`, up to the next one of any level. Tables become items,
/// their first column the label; links their text. @throws std::logic_error where there is no such
/// heading.
Blocks markdown_section(std::string_view page, std::string_view heading);

}  // namespace lasius::tool
