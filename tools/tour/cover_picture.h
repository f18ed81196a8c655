// The picture of a tour that covers a map.
#pragma once

#include <string>

#include "lasius/tour/cover.h"
#include "tools/options/options.h"
#include "tools/tour/tour_answer.h"

namespace lasius::tool {

/// The map, what the tool works on (so many cells wide), the swaths, and the ways between them.
/// `answer.tour` is that of `cover`. @throws Error(output_failed)
void write_cover_picture(const std::string& file, const RunOptions& run, const TourAnswer& answer,
                         const CoverResult& cover, double width);

}  // namespace lasius::tool
