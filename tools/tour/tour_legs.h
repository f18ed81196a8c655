// The legs of a tour on a map, as results tell them.
#pragma once

#include <vector>

#include "tools/record/json_values.h"
#include "tools/tour/tour_answer.h"

namespace lasius::tool {

/// The path along all legs, in cells, or metres from stop to stop as these were given; of one stop
/// its place; empty without a tour.
std::vector<Point> tour_path(const TourAnswer& answer, bool in_metres);
/// [{from, to, length, path}, ...], with the legs' costs and paths in metres where there are any.
Json legs_json(const TourAnswer& answer, bool in_metres);

}  // namespace lasius::tool
