// Coordinates shared by the whole library: x is the column, y the row, (0, 0) the top left.
#pragma once

namespace lasius {

/// A cell of a bitmap. It covers the closed square [x, x + 1] x [y, y + 1].
struct Cell {
  int x = 0;  ///< column
  int y = 0;  ///< row
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cells (x, y) to (x + width - 1, y + height - 1).
struct Rectangle {
  int x = 0;       ///< first column
  int y = 0;       ///< first row
  int width = 0;   ///< columns, at least 0
  int height = 0;  ///< rows, at least 0
  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// On a bitmap a point in continuous cell coordinates, y downwards; the centre of cell (0, 0) is
/// (0.5, 0.5). Among polygons a point in the world's unit, y up.
struct Point {
  double x = 0;  ///< to the right
  double y = 0;  ///< downwards on a bitmap, up among polygons
  friend bool operator==(const Point&, const Point&) = default;
};

/// The centre of a cell.
constexpr Point centre(Cell c) noexcept { return {c.x + 0.5, c.y + 0.5}; }

}  // namespace lasius
