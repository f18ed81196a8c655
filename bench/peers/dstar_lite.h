// D* Lite: the incremental search that robots use where the map changes.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "bench/peers/move_grid.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::peers {

/// D* Lite, its second version (Koenig & Likhachev 2002, figure 4), on 8 neighbours without corner
/// cutting and whole costs, see OctileCosts: searches from the goal to the robot, and repairs what
/// a change has made wrong.
class DStarLite {
 public:
  /// At most 25 million cells.
  DStarLite(Grid map, Cell robot, Cell goal);

  /// Each of these cells of the map is blocked, or free. The robot is where it was last.
  void observe(std::span<const Cell> cells, bool blocked);
  /// Length of the shortest walk from where the robot is now, in cells; infinite without one.
  double plan(Cell robot);
  /// The next cell of that walk; the robot's own at the goal. Precondition: there is a walk.
  Cell next() const;

 private:
  using Cost = std::uint32_t;
  using Index = std::uint32_t;
  using Key = std::pair<std::int64_t, std::int64_t>;
  struct Node {
    Cost g, rhs;
    std::uint32_t place;  // in the heap, from 1; 0: not there
  };

  Cost heuristic(Index i) const noexcept;
  Key key(Index i) const noexcept;
  /// Calls `visit` with each cell that a move leads to, and its cost.
  template <class Visit>
  void each_move(Index from, const Visit& visit) const;
  Cost best_rhs(Index i) const noexcept;
  void update(Index i);
  void expand(Index i);
  void search();

  // An indexed binary heap, least key first.
  void put(std::size_t place, const std::pair<Key, Index>& entry) noexcept;
  void sift_up(std::size_t place);
  void sift_down(std::size_t place);
  void remove(Index i);
  void set_key(Index i, const Key& key);

  Grid map_;
  MoveGrid moves_;
  Index robot_, goal_;
  std::int64_t km_ = 0;
  std::vector<Node> nodes_;
  std::vector<std::pair<Key, Index>> heap_;  // from 1
};

}  // namespace lasius::peers
