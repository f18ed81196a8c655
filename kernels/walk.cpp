#include "kernels/walk.h"

namespace lasius::kernels {

const WalkTable& scalar_walk_table() noexcept;
const WalkTable& avx2_walk_table() noexcept;
const WalkTable& avx512_walk_table() noexcept;

const WalkTable& walk_table(Isa isa) noexcept {
#if defined(__x86_64__)
  if (isa == Isa::avx512) return avx512_walk_table();
  if (isa == Isa::avx2) return avx2_walk_table();
#endif
  return (void)isa, scalar_walk_table();
}

}  // namespace lasius::kernels
