#include "bench/peers/move_grid.h"

namespace lasius::peers {

MoveGrid::MoveGrid(const Grid& grid) : stride_(static_cast<std::uint32_t>(grid.width())) {
  for (std::size_t k = 0; k < 8; ++k) {
    offsets_[k] = kMoveY[k] * static_cast<std::int32_t>(stride_) + kMoveX[k];
  }
  moves_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(grid.height()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.blocked({x, y})) continue;
      const bool east = grid.free({x + 1, y}), west = grid.free({x - 1, y});
      const bool south = grid.free({x, y + 1}), north = grid.free({x, y - 1});
      const bool legal[8] = {east,
                             west,
                             south,
                             north,
                             south && east && grid.free({x + 1, y + 1}),
                             south && west && grid.free({x - 1, y + 1}),
                             north && east && grid.free({x + 1, y - 1}),
                             north && west && grid.free({x - 1, y - 1})};
      unsigned mask = 0;
      for (unsigned k = 0; k < 8; ++k) mask |= static_cast<unsigned>(legal[k]) << k;
      moves_[index({x, y})] = static_cast<std::uint8_t>(mask);
    }
  }
}

}  // namespace lasius::peers
