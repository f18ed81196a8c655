// `drive`: a robot through a world that is not as its map has it.
#pragma once

#include <memory>

#include "tools/record/task.h"

namespace lasius::tool {

/// A result's drive again. @throws Error, UsageError
std::unique_ptr<Task> recorded_drive(const Recorded& recorded);

}  // namespace lasius::tool
