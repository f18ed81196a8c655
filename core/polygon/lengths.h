// Lengths of shortest paths among polygons, many to many.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/polygon/route.h"
#include "lasius/base/stop.h"

namespace lasius::polygon {

/// The lengths between all of some places, row by row, the same both ways; infinite where they are
/// not joined. What corners see is found once, then each row is Dijkstra's search over that (see
/// shortest_path). Nothing if stopped.
std::optional<std::vector<double>> lengths_among(const Regions& regions,
                                                 std::span<const Place> places, int threads,
                                                 const StopCondition& stop);

}  // namespace lasius::polygon
