// `plan` and each query of `batch` on a polygon world.
#pragma once

#include <memory>

#include "tools/record/task.h"

namespace lasius::tool {

struct LoadedWorld;
using SharedWorld = std::shared_ptr<const LoadedWorld>;

/// A result's question again. `last` keeps its world for the next: the lines of a batch share one.
std::unique_ptr<Task> recorded_polygon(const Recorded& recorded, SharedWorld& last);

}  // namespace lasius::tool
