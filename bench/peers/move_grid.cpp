#include "bench/peers/move_grid.h"

namespace lasius::peers {

MoveGrid::MoveGrid(const Grid& grid) : stride_(static_cast<std::uint32_t>(grid.width())) {
  for (std::size_t k = 0; k < 8; ++k) {
    offsets_[k] = kMoveY[k] * static_cast<std::int32_t>(stride_) + kMoveX[k];
  }
  moves_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(grid.height()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) renew(grid, {x, y});
  }
}

void MoveGrid::renew(const Grid& grid, Cell c) noexcept {
  unsigned mask = 0;
  for (unsigned k = 0; k < 8 && grid.free(c); ++k) {
    const int to_x = c.x + kMoveX[k], to_y = c.y + kMoveY[k];
    const bool legal = grid.free({to_x, c.y}) && grid.free({c.x, to_y}) && grid.free({to_x, to_y});
    mask |= static_cast<unsigned>(legal) << k;
  }
  moves_[index(c)] = static_cast<std::uint8_t>(mask);
}

}  // namespace lasius::peers
