// A result on a polygon world, made a question again.
#pragma once

#include <memory>

#include "tools/record/task.h"

namespace lasius::tool {

std::unique_ptr<Task> recorded_polygon(const Recorded& recorded);

}  // namespace lasius::tool
