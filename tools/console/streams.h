// Standard output for data, standard error for messages.
#pragma once

#include <string_view>

namespace lasius::tool {

/// Opens /dev/null on each standard stream that the caller closed, so that no file that is opened
/// later takes its number; makes a closed pipe an error of the write instead of a signal.
void guard_standard_streams();

/// Thrown when nobody reads standard output any more: the program then ends quietly.
struct ClosedOutput {};

/// Writes data on standard output and flushes it.
/// @throws ClosedOutput; Error(output_failed) for any other failure.
void print(std::string_view text);
/// The same of what the exit code says, too: it does where nobody reads any more.
/// @throws Error(output_failed) for any other failure.
void print_verdict(std::string_view text);

/// "lasius: TEXT" on standard error.
void message(std::string_view text);

}  // namespace lasius::tool
