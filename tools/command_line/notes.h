// What is said of each command beside its options: examples, exit codes, JSON, files by ending.
#pragma once

#include <string_view>

#include "tools/options/manual.h"

namespace lasius::tool {

/// Those of the command; of one that has none of its own the exit codes that all have.
Notes notes_of(std::string_view command);

/// What a shell may write for an option or argument of the command: by the notes, else by what its
/// value is called: FILE, DIR, or choices as in "a|b".
Values values_of(std::string_view command, std::string_view name, std::string_view value);

}  // namespace lasius::tool
