// The picture of a tour.
#pragma once

#include <string>
#include <string_view>

#include "tools/options/options.h"
#include "tools/tour/tour_answer.h"

namespace lasius::tool {

/// The map, the tour, by `algorithm`, and its stops, which are numbered from 1 in their order where
/// they are few; each robot has its colour. @throws Error(output_failed)
void write_tour_picture(const std::string& file, std::string_view algorithm, const RunOptions& run,
                        const TourAnswer& answer);

}  // namespace lasius::tool
