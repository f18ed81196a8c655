// The cheapest walk by eight moves from centre to centre.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/cost/terrain.h"
#include "lasius/moves.h"

namespace lasius::cost {

/// A* in buckets with octile distances at the least weight. A move costs its length times the mean
/// of both weights, which is the integral along it: of a diagonal one half lies in either cell.
class EightMoves {
 public:
  /// The cells of a cheapest walk, start to goal, both free; empty where there is none, or when
  /// stopped.
  /// @param knights  moves of a knight, too, straight through the two cells between
  std::vector<Cell> search(const Terrain& terrain, Cell start, Cell goal, Corners corners,
                           Poller& poller, bool knights);
  std::int64_t bytes() const noexcept { return cost_.bytes() + from_.bytes() + queue_.bytes(); }

 private:
  GrowingArray<double> cost_;
  GrowingArray<std::uint8_t> from_;  // the move that led here
  BucketQueue queue_;
};

}  // namespace lasius::cost
