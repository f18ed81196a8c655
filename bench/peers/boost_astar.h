// Boost.Graph's A*.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/move_grid.h"
#include "bench/peers/query_planner.h"

namespace lasius::peers {

/// boost::astar_search_no_init over the implicit grid graph: shortest octile path. Its maps are
/// stamped, so that a query initialises only the cells that it meets; the heap's own index is a
/// vector that Boost grows anew each time.
class BoostAStar final : public QueryPlanner {
 public:
  explicit BoostAStar(const Grid& grid);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

  /// What the search keeps of a cell, valid when the stamp is the query's.
  struct Node {
    double distance, bound;
    std::uint32_t predecessor, stamp;
    std::uint8_t colour;
  };

 private:
  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::uint32_t stamp_ = 0;
};

}  // namespace lasius::peers
