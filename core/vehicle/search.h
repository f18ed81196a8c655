// The search over a vehicle's lattice, from exact start to exact goals.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/connectors.h"
#include "core/vehicle/made_once.h"
#include "core/vehicle/prices.h"
#include "core/vehicle/search_memory.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

/// What all searches on a map share.
struct Prepared {
  const Space::Impl& space;
  const Lattice& lattice;
  const FreeHeadings& free;
  const MadeOnce<EdgePlanes>& planes;  ///< made by the first search that is hard
  const Prices& prices;
  const EdgePrices* edges;  ///< over weights, else null
};

/// A pose that ends a path, and whose goal it is.
struct Goal {
  Pose pose;
  int index = 0;
};

/// What a search found.
struct Found {
  std::vector<Segment> segments;
  double cost = 0;    ///< as Prices has it
  int goal = -1;      ///< index; -1: no path
  bool full = false;  ///< ended since so many states were entered
};

struct SearchOptions {
  double weight = 1.5;
  double lattice_tolerance = 0;  ///< poses of the lattice so near a goal are ends, too, cells
  double heading_tolerance = 0;
  std::span<const Pose> wanted = {};  ///< goals as they were asked for
  bool wide = false;                  ///< longer connectors and more shots
  bool creeps = false;                ///< and, out of pockets, small motions
  std::int64_t max_states = 0;
  StopCondition stop = {};
};

/// Searches once. Counts what it does in the result.
Found search(const Prepared& prepared, const Pose& start, std::span<const Goal> goals,
             const SearchOptions& options, SearchMemory& memory, Result& counts, Poller& poller);

}  // namespace lasius::vehicle
