#include "core/vehicle/search_ends.h"

#include <algorithm>
#include <iterator>

#include "core/vehicle/escape.h"

namespace lasius::vehicle {

SearchEnds ends_of_search(const Prepared& prepared, const Pose& start, std::span<const Goal> goals,
                          const SearchOptions& options, Result& counts, Poller& poller) {
  const Space::Impl& space = prepared.space;
  const Lattice& lattice = prepared.lattice;
  SearchEnds ends;
  const double near = std::max(space.vehicle().turning_radius, 4.0);
  const ConnectorReach brief{std::min(near, 30.0), 12, 1.35};
  const ConnectorReach wide{std::min(3 * near, 60.0), 1.5 * near, 1.35};
  const auto all_of = [&](const Pose& pose, bool towards) {
    std::vector<Connector> made = connectors(space, lattice, pose, towards,
                                             options.wide ? wide : brief, counts.checked, poller);
    if (!options.wide) return made;
    std::vector<Connector> more =
        escapes(space, lattice, pose, towards, options.creeps, brief, counts.checked, poller);
    std::ranges::move(more, std::back_inserter(made));
    return made;
  };
  const auto lead_to = [&](int goal, std::vector<Connector> made) {
    for (Connector& c : made) {
      c.end = goal;
      ends.to_goal.push_back(std::move(c));
    }
  };
  ends.from_start = all_of(start, false);
  for (std::size_t i = 0; i < goals.size() && !poller.stopped(); ++i)
    lead_to(goals[i].index, all_of(goals[i].pose, true));
  for (int i = 0; i < static_cast<int>(options.wanted.size()); ++i)
    lead_to(i, tolerated(space, lattice, options.wanted[i], options.lattice_tolerance,
                         options.heading_tolerance, poller));
  if (!prepared.prices.weighted()) return ends;
  for (std::vector<Connector>* made : {&ends.from_start, &ends.to_goal})
    for (Connector& c : *made) c.cost = prepared.prices.of(c.motions);
  return ends;
}

}  // namespace lasius::vehicle
