// Which changes a map can have, and which drives there are.
#pragma once

#include <optional>
#include <string>

#include "lasius/drive/drive.h"

namespace lasius {

/// What is wrong with a change to a map of this size, or nothing.
std::optional<std::string> fault_of(const Change& change, int width, int height);
std::optional<std::string> fault_of(const MovingObstacle& obstacle, int width, int height);

/// @throws Error(invalid_parameter) for the first that is wrong.
void check_changes(const Changes& changes, int width, int height);
/// The same for what a drive is asked.
void check_drive(const Grid& map, const Grid& truth, const DriveOptions& options);

}  // namespace lasius
