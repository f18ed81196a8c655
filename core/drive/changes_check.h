// Which changes a map can have.
#pragma once

#include <optional>
#include <string>

#include "lasius/drive.h"

namespace lasius {

/// What is wrong with a change to a map of this size, or nothing.
std::optional<std::string> fault_of(const Change& change, int width, int height);
std::optional<std::string> fault_of(const MovingObstacle& obstacle, int width, int height);

/// @throws Error(invalid_parameter) for the first that is wrong.
void check_changes(const Changes& changes, int width, int height);

}  // namespace lasius
