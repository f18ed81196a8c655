#include "kernels/walk/walk_tables.h"

namespace lasius::kernels {

const WalkTable& walk_table([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
  if (isa == Isa::avx512) return avx512_walk_table();
  if (isa == Isa::avx2) return avx2_walk_table();
#endif
  return scalar_walk_table();
}

}  // namespace lasius::kernels
