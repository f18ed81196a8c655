// The picture of a tour.
#pragma once

#include <string>

#include "tools/options/options.h"
#include "tools/tour/tour_answer.h"

namespace lasius::tool {

/// The map, the tour, and its stops, which are numbered from 1 in their order where they are few.
/// @throws Error(output_failed)
void write_tour_picture(const std::string& file, const RunOptions& run, const TourAnswer& answer);

}  // namespace lasius::tool
