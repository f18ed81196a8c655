// Texts of others in messages.
#pragma once

#include <string>
#include <string_view>

#include "lasius/export.h"

namespace lasius {

/// The text with control characters as \x1b, line ends and tabs too: what stands in a file or a
/// name neither cuts a message short, nor looks like another, nor steers a terminal.
LASIUS_EXPORT std::string printable(std::string_view text);

}  // namespace lasius
