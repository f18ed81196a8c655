// The command line.
#pragma once

#include "tools/options/options.h"

namespace lasius::tool {

/// Reads the command line, and of files whether they are streams. @throws UsageError;
/// Error(invalid_parameter) for a value that the library refuses.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace lasius::tool
