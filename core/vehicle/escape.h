// Ends beside a wall: small motions away from it, and connectors from there.
#pragma once

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

}  // namespace lasius::vehicle
