#include "kernels/walk.h"

namespace lasius::kernels {

const WalkTable& scalar_walk_table() noexcept;
const WalkTable& avx2_walk_table() noexcept;

const WalkTable& walk_table(Isa isa) noexcept {
#if defined(__x86_64__)
  if (isa >= Isa::avx2) return avx2_walk_table();
#endif
  return (void)isa, scalar_walk_table();
}

Moves moves_of(int neighbours) noexcept {
  Moves moves;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int taxicab = (dx != 0) + (dy != 0);
      if (taxicab == 0 || (neighbours == 4 && taxicab == 2)) continue;
      moves.dx[moves.count] = static_cast<std::int8_t>(dx);
      moves.dy[moves.count] = static_cast<std::int8_t>(dy);
      ++moves.count;
    }
  }
  return moves;
}

}  // namespace lasius::kernels
