// What joins the ends of a search to the lattice.
#pragma once

#include <span>
#include <vector>

#include "core/vehicle/search.h"

namespace lasius::vehicle {

/// Connectors from the start, and to the goals; within a tolerance poses of the lattice among them.
struct SearchEnds {
  std::vector<Connector> from_start, to_goal;
};
/// With their costs as Prices has them. Counts what it certifies in the result.
SearchEnds ends_of_search(const Prepared& prepared, const Pose& start, std::span<const Goal> goals,
                          const SearchOptions& options, Result& counts, Poller& poller);

}  // namespace lasius::vehicle
