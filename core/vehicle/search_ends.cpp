#include "core/vehicle/search_ends.h"

#include <algorithm>
#include <iterator>

#include "core/vehicle/escape.h"

namespace lasius::vehicle {
namespace {

double near_of(const Vehicle& vehicle) { return std::max(vehicle.turning_radius, 4.0); }
ConnectorReach brief_reach(const Vehicle& vehicle) {
  return {std::min(near_of(vehicle), 30.0), 12, 1.35};
}

}  // namespace

SearchEnds ends_of_search(const Prepared& prepared, const Pose& start, std::span<const Goal> goals,
                          const SearchOptions& options, Result& counts, Poller& poller) {
  const Space::Impl& space = prepared.space;
  const Lattice& lattice = prepared.lattice;
  SearchEnds ends;
  const double near = near_of(space.vehicle());
  const ConnectorReach brief = brief_reach(space.vehicle());
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

std::vector<Connector> connectors_across(
    const Prepared& prepared, States<Reached>& reached, const std::function<double(int, int)>& left,
    const std::function<void(std::uint32_t, std::vector<Segment>&)>& way_to, Result& counts,
    Poller& poller) {
  constexpr std::size_t kFrom = 16;
  std::vector<std::pair<float, std::uint32_t>> near;
  for (std::uint32_t i = 0; i < reached.size(); ++i)
    if (reached[i].expanded) near.push_back({reached[i].left, i});
  if (near.empty()) return {};
  const auto last = near.begin() + static_cast<std::ptrdiff_t>(std::min(kFrom, near.size()));
  std::partial_sort(near.begin(), last, near.end());
  near.erase(last, near.end());
  std::vector<Pose> from;
  from.reserve(near.size());
  for (const auto& [far, i] : near) {
    const Cell at = reached.cell(i);
    from.push_back(prepared.lattice.pose(at.x, at.y, reached.heading(i)));
  }
  const double least = left(floor_of(from[0].x), floor_of(from[0].y));
  std::vector<Connector> made;
  for (Crossing& c : crossings(
           prepared.space, prepared.lattice, from, left,
           [&](const Connector& to) { return left(to.x, to.y) < least - 1; },
           brief_reach(prepared.space.vehicle()), counts.checked, poller)) {
    std::vector<Segment> way;
    way_to(near[c.from].second, way);
    std::vector<Segment>& motions = c.connector.motions;
    motions.insert(motions.begin(), way.begin(), way.end());
    c.connector.cost = prepared.prices.of(motions);
    made.push_back(std::move(c.connector));
  }
  return made;
}

}  // namespace lasius::vehicle
