// Where a disc that is beside its path goes on along it.
#pragma once

#include <vector>

#include "core/disc/disc_space.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// Makes of a path in a disc's free space, of two points or more, what is left of it from a place
/// beside it where the disc may be: straight to the farthest of the next vertices that the disc
/// sees, or to a place on the side before them. False where it sees none: the path is as it was.
bool rejoin(const disc::DiscSpace& space, Point robot, std::vector<Point>& path);

}  // namespace lasius
