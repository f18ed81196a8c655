// The eight moves of every cell, looked up once per map.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lasius/grid/grid.h"

namespace lasius::peers {

/// Moves 0 .. 7: E, W, S, N, SE, SW, NE, NW; the first four are straight.
inline constexpr std::array<int, 8> kMoveX = {1, -1, 0, 0, 1, -1, 1, -1};
inline constexpr std::array<int, 8> kMoveY = {0, 0, 1, -1, 1, 1, -1, -1};

/// One byte a cell: bit k is set when move k is legal (a diagonal needs both side cells free).
/// Cells are numbered row by row, y * stride + x, without a border: masks keep moves inside.
class MoveGrid {
 public:
  explicit MoveGrid(const Grid& grid);

  /// Looks up the moves of one cell of the grid again.
  void renew(const Grid& grid, Cell c) noexcept;

  std::uint32_t index(Cell c) const noexcept {
    return static_cast<std::uint32_t>(c.y) * stride_ + static_cast<std::uint32_t>(c.x);
  }
  Cell cell(std::uint32_t index) const noexcept {
    return {static_cast<int>(index % stride_), static_cast<int>(index / stride_)};
  }
  std::uint8_t moves(std::uint32_t index) const noexcept { return moves_[index]; }
  std::size_t size() const noexcept { return moves_.size(); }
  /// What each move adds to a cell's index.
  const std::array<std::int32_t, 8>& offsets() const noexcept { return offsets_; }

 private:
  std::uint32_t stride_;
  std::array<std::int32_t, 8> offsets_{};
  std::vector<std::uint8_t> moves_;
};

}  // namespace lasius::peers
