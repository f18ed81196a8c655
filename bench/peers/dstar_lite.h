// D* Lite: the incremental search that robots use where the map changes.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/grid.h"

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

  Index index(Cell c) const noexcept { return static_cast<Index>(c.y * map_.width() + c.x); }
  Cell cell(Index i) const noexcept {
    return {static_cast<int>(i) % map_.width(), static_cast<int>(i) / map_.width()};
  }
  Cost heuristic(Index i) const noexcept;
  Key key(Index i) const noexcept;
  std::uint8_t legal_moves(Cell c) const noexcept;
  Cost cost(int move) const noexcept;
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
  Index robot_, goal_;
  std::int64_t km_ = 0;
  std::vector<std::uint8_t> moves_;
  std::vector<Node> nodes_;
  std::vector<std::pair<Key, Index>> heap_;  // from 1
};

}  // namespace lasius::peers
