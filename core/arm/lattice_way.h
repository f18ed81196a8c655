// Ways through a lattice: the shortest as far as it is known, and the straightest.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/arm/lattice.h"
#include "lasius/stop.h"

namespace lasius::arm {

/// Moves of a shortest way from start to goal along edges that may be open; nothing without one.
struct KnownWay {
  StopCondition::Cause cause = StopCondition::Cause::none;
  std::optional<std::int64_t> moves;  ///< empty although not stopped: proven, there is no way
};

enum class Unknown { counts_as_free, is_asked };

/// A* with the Manhattan distance, which never overestimates. Where what was not tried counts as
/// free no way is shorter; kinematics is worked out on the fly, the sensor is not asked.
KnownWay shortest_known_way(const Lattice& lattice, Unknown unknown, const StopCondition& stop);

/// The moves from start to goal that keep nearest to the straight line: each along the axis that
/// lags most behind its share of the way. Asks nothing.
std::vector<int> straight_moves(const Lattice& lattice);

}  // namespace lasius::arm
