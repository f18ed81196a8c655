// A* on 8 neighbours with a bucket queue: the strong baseline of grid search.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bench/peers/move_grid.h"
#include "bench/peers/query_planner.h"

namespace lasius::peers {

/// Shortest octile path, no corner cutting (A*: Hart, Nilsson & Raphael 1968; bucket queue: Dial
/// 1969), on integer costs whose ratio is a convergent of sqrt 2.
///
/// Reduced costs of the octile distance are 0 or at least 2 - sqrt 2, so with buckets narrower than
/// that only free moves stay inside a bucket: last in, first out within it, reopening the few cells
/// that are improved there, and cells no better than the goal are dropped.
class BucketAStar final : public QueryPlanner {
 public:
  explicit BucketAStar(const Grid& grid);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;
  /// The cells of a shortest path, start to goal, in `cells`; its length or kNoPath.
  double plan_cells(Cell start, Cell goal, std::vector<Cell>& cells);

 private:
  // A cell's state: valid when the stamp is the query's.
  struct Node {
    std::uint32_t cost;
    std::uint32_t state;  // stamp << 4 | closed << 3 | move that led here
  };
  struct Item {
    std::uint32_t index;
    std::uint16_t x, y;
  };
  enum class Outcome { reached, unreachable, overflow };

  static constexpr std::uint32_t kBuckets = 32;
  static constexpr std::uint32_t kClosed = 8;

  void use_scale(std::size_t scale);
  Outcome search(Cell start, Cell goal);
  double trace(Cell start, Cell goal, std::vector<Cell>& cells) const;

  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::array<std::vector<Item>, kBuckets> buckets_;
  std::vector<Cell> cells_;
  std::uint32_t stamp_ = 0;
  std::size_t scale_ = 0;
  unsigned bucket_shift_ = 0;
};

}  // namespace lasius::peers
