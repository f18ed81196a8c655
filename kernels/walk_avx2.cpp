// The walk with AVX2.

#include "kernels/walk_tables.h"

#if defined(__x86_64__)

#define LASIUS_TARGET [[gnu::target("avx2,bmi,bmi2")]]
#define LASIUS_MASKS 0
#include "kernels/walk_vector.h"
#define LASIUS_OPS VectorOps
#include "kernels/walk_body.h"

namespace lasius::kernels {

const WalkTable& avx2_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels

#endif
