// The command line.
#pragma once

namespace lasius::tool {

/// Reads the command line and does what it asks for. The program's exit code. @throws UsageError;
/// Error(invalid_parameter) for a value that the library refuses; what commands throw.
int run_command_line(int argc, const char* const* argv);

}  // namespace lasius::tool
