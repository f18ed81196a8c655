// The cheapest walk by eight moves from centre to centre.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/cost/terrain.h"
#include "lasius/grid/moves.h"

namespace lasius::cost {

/// A* in buckets from both ends with octile distances at the least weight. A move costs its length
/// times the mean of both weights, which is the integral along it: of a diagonal one half lies in
/// either cell.
class EightMoves {
 public:
  /// The cells of a cheapest walk, start to goal, both free; empty where there is none, or when
  /// stopped.
  /// @param knights  moves of a knight, too, straight through the two cells between
  std::vector<Cell> search(const Terrain& terrain, Cell start, Cell goal, Corners corners,
                           Poller& poller, bool knights);
  std::int64_t bytes() const noexcept { return sides_[0].bytes() + sides_[1].bytes(); }

 private:
  struct Question;
  struct Side {
    Cell source, target;
    std::int64_t waiting = 0;  // entries of the queue
    GrowingArray<double> cost;
    GrowingArray<std::uint8_t> from;  // the move that led here
    BucketQueue queue;

    void begin(const Question& question, Cell from_cell, Cell to_cell);
    std::int64_t bytes() const noexcept { return cost.bytes() + from.bytes() + queue.bytes(); }
  };

  void spread(Side& side, const Side& other, const Question& question);

  Side sides_[2];            // from the start, from the goal
  double best_ = kInfinity;  // of walks that were found
  std::size_t meeting_ = 0;  // where both of its parts end
};

}  // namespace lasius::cost
