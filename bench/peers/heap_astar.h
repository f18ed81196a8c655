// A* on 8 neighbours with a binary heap: what most robots run.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/move_grid.h"
#include "bench/peers/octile_costs.h"
#include "bench/peers/query_planner.h"

namespace lasius::peers {

/// Shortest octile path, no corner cutting (Hart, Nilsson & Raphael 1968): binary heap with stale
/// entries dropped when they are taken, ties broken towards the goal.
class HeapAStar final : public QueryPlanner {
 public:
  explicit HeapAStar(const Grid& grid);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

 private:
  struct Node {
    std::uint32_t cost;
    std::uint32_t state;  // stamp << 3 | move that led here
  };
  struct Item {
    std::uint64_t key;  // bound, then the cost still to go: the smaller the better
    std::uint32_t index;
    std::uint16_t x, y;
    // The standard heap keeps the largest on top.
    bool operator<(const Item& o) const noexcept { return key > o.key; }
  };
  enum class Outcome { reached, unreachable, overflow };

  Outcome search(Cell start, Cell goal);

  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::vector<Item> heap_;
  std::uint32_t stamp_ = 0;
  std::size_t scale_ = 0;
};

}  // namespace lasius::peers
