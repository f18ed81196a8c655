// The program's exit codes and the errors that are its own.
#pragma once

#include <stdexcept>
#include <string_view>

#include "core/base/printable.h"

namespace lasius::tool {

/// What the program returns; scripts rely on these numbers.
enum Exit : int {
  kFound = 0,         ///< a path was returned, or the command did its work
  kInternal = 1,      ///< a fault of the program; `verify`: the replay differs
  kUsage = 2,         ///< the command line
  kBadFile = 3,       ///< a map, query or result file is missing or broken
  kInvalidQuery = 4,  ///< start or goal outside or blocked
  kUnreachable = 5,   ///< proven: no path exists
  kNoPath = 6,        ///< limit or iterations spent without a path
  kNoOutput = 7,      ///< an output cannot be written
  kInterrupted = 130,
};

/// A mistake on the command line; the message names the value and the nearest known one.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(std::string_view text) : std::runtime_error(printable(text)) {}
};

}  // namespace lasius::tool
