// A path of the plane as a walk of cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// The rule by which a robot moves along paths that obey another: beside a corner that may be cut a
/// path touches the other side, too, so only a rule that lets paths squeeze is needed.
constexpr Corners rule_of_walks(Corners of_paths) noexcept {
  return of_paths == Corners::allow ? Corners::allow : Corners::forbid;
}

/// True when the closed segment between two points at multiples of 0.5 touches a cell's square.
bool touches(Point a, Point b, Cell cell) noexcept;

/// Makes a walk of a path, piece by piece: by moves to one of the eight neighbours, over free cells
/// that the path touches.
class PathWalker {
 public:
  /// Begins a path with vertices at multiples of 0.5, or of a disc: with any. A disc's walk may go
  /// over the cells beside those that the path touches, too.
  void begin(std::vector<Point> path, bool of_disc = false);
  /// The next piece: the shortest walk from `from`, on which the last piece ended, to a cell that
  /// the path touches some dozens of columns or rows further on, or to the path's end. `from` comes
  /// first; it is alone at the path's end, and where the path is not valid.
  void next(const Grid& grid, Corners corners, Cell from, std::vector<Cell>& walk);

  /// True when what is left of the path, from the beginning of the last piece, touches a cell.
  bool touches_rest(Cell cell) const noexcept;
  /// Vertices behind the end of the last piece's last segment that touches a cell.
  std::size_t vertices_after(Cell cell) const noexcept;

 private:
  /// The columns of a segment, rows where it is steeper than a diagonal: a line of cells each.
  struct Lines;
  static constexpr int kLines = 48;            // in a piece
  static constexpr int kBox = 2 * kLines + 9;  // cells of a piece lie in a square of this side

  struct Node {
    Cell cell;
    double length;
    std::int32_t parent;
    bool done;
  };

  bool gather(const Grid& grid, Cell from);
  void add(const Grid& grid, Cell cell);
  std::int32_t& slot(Cell cell) noexcept;
  void search(const Grid& grid, Corners corners);

  std::vector<Point> path_;
  int beside_ = 0;                               // so many cells to each side
  std::size_t segment_ = 0, begun_segment_ = 0;  // where the next piece begins, and the last one
  int line_ = 0;                                 // of segment_, from its first
  Cell corner_;                                  // of the box
  std::vector<Node> nodes_;
  std::vector<std::int32_t> last_line_;  // nodes of the line in hand
  std::vector<std::int32_t> slots_ = std::vector<std::int32_t>(std::size_t{kBox} * kBox, -1);
};

}  // namespace lasius
