// Theta* and Lazy Theta*: A* on 8 neighbours whose parents need only be in sight.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/move_grid.h"
#include "bench/peers/query_planner.h"

namespace lasius::peers {

/// Any-angle paths over cell centres, close to the shortest but not exact. Basic Theta* (Nash,
/// Daniel, Koenig & Felner 2007) looks for sight when a neighbour is generated, Lazy Theta* (Nash,
/// Koenig & Tovey 2010) once, when a cell is expanded. Sight is looked for only where it can
/// shorten, which changes no path.
class ThetaStar final : public QueryPlanner {
 public:
  enum class Kind { basic, lazy };
  ThetaStar(const Grid& grid, Kind kind);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

 private:
  struct Node {
    double cost;
    std::uint32_t parent;
    std::uint32_t state;  // 2 * stamp, + 1 when closed
  };
  struct Item {
    double bound, cost;
    std::uint32_t index;
    std::uint16_t x, y;
    bool operator<(const Item& o) const noexcept {
      return bound != o.bound ? bound > o.bound : cost < o.cost;
    }
  };

  template <Kind kKind>
  void expand(const Item& item, Cell goal);
  void find_parent(const Item& item);
  void offer(std::uint32_t index, Cell c, double cost, std::uint32_t parent, Cell goal);

  const Grid* grid_;
  Kind kind_;
  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::vector<Item> heap_;
  std::uint32_t mark_ = 0;
};

}  // namespace lasius::peers
