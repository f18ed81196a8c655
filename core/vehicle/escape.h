// Ends beside a wall: small motions away from it, and connectors from there.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/vehicle/connectors.h"

namespace lasius::vehicle {

/// Connectors that begin (towards: end) with motions of the vehicle's own, off the lattice, which
/// lead to where its footprint has room for the lattice; none where none is found, and where it has
/// that already unless it `creeps`. An end nearer than 0.001 cells to what is blocked has none.
/// @param creeps  by small motions, out of a bent pocket; where it has room by gentle ones, too
std::vector<Connector> escapes(const Space::Impl& space, const Lattice& lattice, const Pose& pose,
                               bool towards, bool creeps, const ConnectorReach& reach,
                               std::int64_t& checked, Poller& poller);

/// Small motions on from a pose of the lattice, and a connector from where they lead.
struct Crossing {
  int from = 0;  ///< index of the pose
  Connector connector;
};

/// Ways by small motions through what no heading of the lattice fits, the shortest first by what
/// is `left` from a cell: all connectors that are `wanted` from the first place that has some.
std::vector<Crossing> crossings(const Space::Impl& space, const Lattice& lattice,
                                std::span<const Pose> from,
                                const std::function<double(int, int)>& left,
                                const std::function<bool(const Connector&)>& wanted,
                                const ConnectorReach& reach, std::int64_t& checked, Poller& poller);

}  // namespace lasius::vehicle
