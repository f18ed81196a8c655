// The walk with AVX2: in lock-step where there are at most eight moves; else interleaved, a row in
// registers.

#include "kernels/walk/walk_tables.h"

#if defined(__x86_64__)

#include "kernels/walk/lockstep.h"
#define LASIUS_TARGET LASIUS_AVX2
#define LASIUS_OPS VectorOps
// After both.
#include "kernels/walk/walk_body.h"

namespace lasius::kernels {

const WalkTable& avx2_walk_table() noexcept { return kTable; }
#if defined(LASIUS_WITHOUT_AVX512)
const WalkTable& avx512_walk_table() noexcept { return kTable; }
#endif

}  // namespace lasius::kernels

#endif
