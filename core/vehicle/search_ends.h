// What joins the ends of a search to the lattice.
#pragma once

#include <functional>
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

/// On from the expanded states from which least is left, by small motions through what no heading
/// of the lattice fits, to where it is a cell less; with the way from the start.
/// @param left  to the goals from a cell
/// @param way_to  appends the way to a state
std::vector<Connector> connectors_across(
    const Prepared& prepared, States<Reached>& reached, const std::function<double(int, int)>& left,
    const std::function<void(std::uint32_t, std::vector<Segment>&)>& way_to, Result& counts,
    Poller& poller);

}  // namespace lasius::vehicle
