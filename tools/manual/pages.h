// The documents that the program tells from.
#pragma once

#include <string_view>

#include "tools/manual/blocks.h"

namespace lasius::tool {

/// What stands below a heading of a document, given as "NAME/HEADING" of docs/NAME.md.
/// @throws std::logic_error where it is not there.
Blocks document_section(std::string_view name);

/// When the program was last released, as 2026-11-23: the date of its manual pages.
std::string_view release_date();

}  // namespace lasius::tool
