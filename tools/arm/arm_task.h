// A result of `lasius arm`, made a question again.
#pragma once

#include <memory>
#include <string>

#include "tools/record/task.h"

namespace lasius::tool {

std::unique_ptr<Task> recorded_arm(const Recorded& recorded);

/// True of results of 0.2.0 and before: they do not say what moves, and less of everything.
bool tells_no_bodies(const Json& result);

/// Why such a result is none that this version would give; empty where it may be.
std::string why_not_replayed(const Recorded& recorded);

}  // namespace lasius::tool
