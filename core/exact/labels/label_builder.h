// Which corners are hubs of which, found by pruned searches.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/exact/labels/taut_graph.h"
#include "lasius/stop.h"

namespace lasius::exact {

/// A hub that a corner knows, the length of the way there, and the next corner on it.
struct HubEntry {
  double length = 0;
  std::uint32_t hub = 0;  ///< its rank
  std::uint32_t next_and_tie = 0;

  HubEntry() = default;
  HubEntry(double way, std::uint32_t rank, std::uint32_t corner, bool tied) noexcept
      : length(way), hub(rank), next_and_tie(corner | (tied ? kTie : 0)) {}

  static constexpr std::uint32_t kTie = std::uint32_t{1} << 31;
  std::uint32_t next() const noexcept { return next_and_tie & ~kTie; }
  /// Is there another way as short?
  bool tied() const noexcept { return (next_and_tie & kTie) != 0; }
};

/// Corners in the order of their rank, and what each knows, by rank of the hub. A hub of a corner
/// is one of the next corner, too, unless that is the hub itself.
struct Hubs {
  std::vector<std::uint32_t> by_rank;
  std::vector<std::vector<HubEntry>> entries;  ///< by corner
  /// Pairs of corners, the smaller one in the upper half, rising, that a hub joins by a way as
  /// short as another one. Let a shortest path between two places not be the only one. Then an
  /// entry on it is tied, or two of its corners are such a pair, or the sums over two hubs are the
  /// least that lead to different paths; see docs/exact.md.
  std::vector<std::uint64_t> ties;
};

constexpr std::uint64_t pair_of(std::uint32_t a, std::uint32_t b) noexcept {
  return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

/// What became of it where there are none.
enum class HubsEnd { ready, too_many, stopped };

/// Hub labels of taut paths: for any two corners that follow each other, near or far, on a shortest
/// path, the corner of the highest rank between them is a hub of both, at its true distance. The
/// same for any number of threads.
/// @param most  entries: where there would be more, it ends early
HubsEnd find_hubs(const TautGraph& graph, std::int64_t most, int threads, const StopCondition& stop,
                  Hubs& hubs);

}  // namespace lasius::exact
