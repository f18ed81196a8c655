// The arcs of a disc's free space, and along which lines it can go from one to another.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/disc/disc_space.h"
#include "core/disc/tangent.h"
#include "lasius/plan/preparation.h"

namespace lasius::disc {

/// A line that leaves one arc and touches another, where the disc's turns are taut at both ends.
struct GraphEdge {
  double angle;  ///< of the normal where it leaves, which is the one where it arrives, too
  std::uint32_t to_and_flags;
  std::int16_t dx, dy;  ///< from the one corner to the other

  std::uint32_t to() const noexcept { return to_and_flags & ~flags(); }  ///< arc
  std::uint32_t flags() const noexcept { return to_and_flags & (kRising | kAcross); }
  bool rising() const noexcept { return (to_and_flags & kRising) != 0; }
  /// Does the line cross from one side of its circles to the other?
  bool across() const noexcept { return (to_and_flags & kAcross) != 0; }
  static constexpr std::uint32_t kRising = std::uint32_t{1} << 31;
  static constexpr std::uint32_t kAcross = std::uint32_t{1} << 30;

  friend bool operator==(const GraphEdge&, const GraphEdge&) = default;
};
static_assert(sizeof(GraphEdge) == 16);

/// For each arc and way to turn around it all lines that lead on, from the arc's far end: those
/// that a disc can take which comes to it at some normal are the first ones.
class DiscGraph {
 public:
  /// Takes a view from every arc, both ways, in parallel; the result does not depend on the
  /// threads. Null if it would take more than the bytes allowed, or was stopped: `report` tells.
  static std::shared_ptr<DiscGraph> make(const DiscSpace& space, const PrepareOptions& options,
                                         Preparation& report);

  std::span<const GraphEdge> edges(std::uint32_t arc, bool rising) const noexcept {
    const std::uint32_t node = 2 * arc + (rising ? 1 : 0);
    const Chunk& chunk = chunks_[node >> kChunkBits];
    const std::uint32_t in_chunk = node & (kChunk - 1);
    return {chunk.edges.data() + chunk.first[in_chunk],
            chunk.edges.data() + chunk.first[in_chunk + 1]};
  }
  std::int64_t edge_count() const noexcept { return edge_count_; }
  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  static constexpr int kChunkBits = 6;
  static constexpr std::uint32_t kChunk = std::uint32_t{1} << kChunkBits;
  class Builder;

  struct Chunk {
    std::vector<GraphEdge> edges;
    std::uint32_t first[kChunk + 1] = {};  // of each arc and turn
  };

  std::vector<Chunk> chunks_;
  std::int64_t edge_count_ = 0;
};

}  // namespace lasius::disc
