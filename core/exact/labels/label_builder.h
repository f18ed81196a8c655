// Which corners are hubs of which, found by pruned searches.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/exact/labels/taut_graph.h"
#include "lasius/base/stop.h"

namespace lasius::exact {

/// A hub that a corner knows, the length of the way there, and the next corner on it.
struct HubEntry {
  double length;
  std::uint32_t hub;   ///< its rank
  std::uint32_t next;  ///< corner
};

/// Corners in the order of their rank, and what each knows, by rank of the hub. A hub of a corner
/// is one of the next corner, too, unless that is the hub itself.
struct Hubs {
  std::vector<std::uint32_t> by_rank;
  std::vector<std::vector<HubEntry>> entries;  ///< by corner
};

/// What became of it, or of another part of labels.
enum class HubsEnd { ready, too_many, stopped };

/// Hub labels of taut paths: for any two corners that follow each other, near or far, on a shortest
/// path, the corner of the highest rank between them is a hub of both, at its true distance. The
/// same for any number of threads.
/// @param most  entries: where there would be more, it ends early
/// @param order  corners by rank, the first the highest; empty: by trees
HubsEnd find_hubs(const TautGraph& graph, std::int64_t most, int threads, const StopCondition& stop,
                  Hubs& hubs, std::vector<std::uint32_t> order = {});

}  // namespace lasius::exact
