// A result of `lasius arm`, made a question again.
#pragma once

#include <memory>

#include "tools/record/task.h"

namespace lasius::tool {

std::unique_ptr<Task> recorded_arm(const Recorded& recorded);

}  // namespace lasius::tool
