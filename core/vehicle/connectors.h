// Exact ends: certified motions from a pose to poses of the lattice about it, and back.
#pragma once

#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/lattice.h"
#include "core/vehicle/sweep.h"

namespace lasius::vehicle {

/// Motions between an end and a pose of the lattice.
struct Connector {
  int x = 0, y = 0, heading = 0;  ///< of the lattice
  double cost = 0;                ///< by the vehicle's prices
  int gear = 0;  ///< of the motion beside the lattice; 0: rotations alone, or nothing
  std::vector<Segment> motions;  ///< as driven
  int end = 0;                   ///< index of the goal
};

/// How far they reach, and what detours they make.
struct ConnectorReach {
  double cells = 0;      ///< between the end and the lattice's pose
  double dense = 0;      ///< beyond that every other cell alone
  double detour = 1.35;  ///< times the distance, and half a cell
};

/// Those that are free. @param towards  from the lattice to the pose
std::vector<Connector> connectors(const Space::Impl& space, const Lattice& lattice,
                                  const Pose& pose, bool towards, const ConnectorReach& reach,
                                  std::int64_t& checked, Poller& poller);

/// Poses of the lattice that are as good as a goal: free, no farther than `far` cells from it and
/// turned from it by at most `turned` radians. None where `far` is 0.
std::vector<Connector> tolerated(const Space::Impl& space, const Lattice& lattice, const Pose& goal,
                                 double far, double turned, Poller& poller);

}  // namespace lasius::vehicle
