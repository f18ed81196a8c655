// How a run ended, whatever the world: the program's exit code, and what people are told.
#pragma once

#include <optional>
#include <string>

#include "lasius/planner.h"

namespace lasius::tool {

/// What is common to the results of all kinds of world.
struct Outcome {
  Status status;
  std::optional<int> iterations;  ///< done, of an algorithm that has any
  bool has_path;
  std::string error;  ///< why it is invalid or unreachable
};

/// The program's exit code for a run.
int exit_code(const Outcome& outcome);

/// One sentence for people: why a run has no path, or is not final; empty for `solved`.
std::string explain(const Outcome& outcome);

}  // namespace lasius::tool
