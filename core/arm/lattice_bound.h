// The shortest way through a lattice as far as it is known.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lasius/stop.h"
#include "lattice.h"

namespace lasius::arm {

/// Moves of a shortest way from start to goal along edges that may be open; nothing without one.
struct KnownWay {
  StopCondition::Cause cause = StopCondition::Cause::none;
  std::optional<std::int64_t> moves;  ///< empty although not stopped: proven, there is no way
};

/// A* with the Manhattan distance, which never overestimates. What was not tried counts as free, so
/// no way is shorter; kinematics is worked out on the fly, the sensor is not asked.
KnownWay shortest_known_way(const Lattice& lattice, const StopCondition& stop);

}  // namespace lasius::arm
