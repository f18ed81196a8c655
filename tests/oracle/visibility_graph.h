// The exact any-angle optimum between two cells, by brute force: a yardstick that shares no code
// with the library's own geometry.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::oracle {

/// A shortest path under the rule of the plane, and its length.
struct Shortest {
  double length;
  std::vector<Point> path;
};

/// The visibility graph over the convex corners of the blocked cells: lattice points where exactly
/// one of the four cells is blocked. Two points are joined when they see each other (decided in
/// integers, cell by cell) and the edge can be part of a taut path. Edges are found while A*
/// asks for them.
class VisibilityGraph {
 public:
  explicit VisibilityGraph(const Grid& grid);

  /// A shortest path between two points whose coordinates are multiples of 1 / kUnit, or nothing
  /// where there is none.
  std::optional<Shortest> shortest(Point start, Point goal) const;
  /// The same between the centres of two cells.
  std::optional<Shortest> shortest(Cell start, Cell goal) const {
    return shortest(centre(start), centre(goal));
  }
  static constexpr int kUnit = 1 << 12;  ///< of a cell's side

  /// Length of a shortest path of king's moves that cut no corner (an upper bound), or infinity.
  double octile(Cell start, Cell goal) const;

 private:
  /// A point in 1 / kUnit of a cell; for a corner also the way (+-1, +-1) to its blocked cell.
  struct Node {
    std::int64_t x;
    std::int64_t y;
    int block_x;
    int block_y;
  };

  bool blocked(int x, int y) const { return blocked_[(y + 1) * (width_ + 2) + x + 1] != 0; }
  bool sees(const Node& a, const Node& b) const;
  bool sees_along(std::int64_t line, std::int64_t from, std::int64_t to, bool level) const;
  static bool along(const Node& a, std::int64_t dx, std::int64_t dy);
  static bool taut(const Node& p, const Node& u, const Node& v);
  /// What no shortest path between two points is longer than, in 1 / kUnit; or infinity.
  double known(const Node& from, const Node& to) const;

  int width_;
  int height_;
  std::vector<char> blocked_;  // with a border of blocked cells
  std::vector<Node> corners_;
};

}  // namespace lasius::oracle
