// `lasius tour MAP --cover WIDTH`: a tour that covers the map.
#pragma once

#include <memory>

#include "tools/options/options.h"
#include "tools/record/problem.h"

namespace lasius::tool {

/// Of a command whose `cover` is given; without stops, goal, costs, ants and target gap.
std::unique_ptr<Problem> cover_problem(TourCommand command);
/// That of a result, but for its run.
void read_recorded_cover(const Json& result, TourCommand& command);

}  // namespace lasius::tool
