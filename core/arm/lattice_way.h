// Ways through a lattice: the shortest as far as it is known, and the straightest.
#pragma once

#include <optional>
#include <vector>

#include "core/arm/lattice.h"
#include "lasius/base/stop.h"

namespace lasius::arm {

/// A cheapest way from start to a goal along edges that may be open; nothing without one.
struct KnownWay {
  StopCondition::Cause cause = StopCondition::Cause::none;
  std::optional<double> cost = {};  ///< empty although not stopped: proven, there is no way
};

enum class Unknown { counts_as_free, is_asked };

/// A* with the lattice's own estimate, which never is too high. An edge is looked at when the way
/// over it is the next to go on with. Where what was not tried counts as free no way is cheaper;
/// kinematics is worked out on the fly, the sensor is not asked.
KnownWay shortest_known_way(Lattice& lattice, Unknown unknown, const StopCondition& stop);

/// The moves from start to the nearest goal that keep nearest to the straight line: each along the
/// axis that lags most behind its share of the way. Asks nothing.
std::vector<int> straight_moves(const Lattice& lattice);

}  // namespace lasius::arm
