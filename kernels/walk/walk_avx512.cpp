// The walk of walk_avx2.cpp, compiled for AVX-512.

#include "kernels/walk/walk_tables.h"

#if defined(__x86_64__)

#define LASIUS_AVX512
#include "kernels/walk/lockstep.h"
#define LASIUS_TARGET LASIUS_AVX2
#define LASIUS_OPS VectorOps
// After both.
#include "kernels/walk/walk_body.h"

namespace lasius::kernels {

const WalkTable& avx512_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels

#endif
