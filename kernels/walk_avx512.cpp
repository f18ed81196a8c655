// The walk with the masks of AVX-512, on registers of AVX2's width.

#include "kernels/walk_tables.h"

#if defined(__x86_64__)

#define LASIUS_TARGET [[gnu::target("avx512f,avx512vl,avx512dq,avx512bw,bmi,bmi2")]]
#define LASIUS_MASKS 1
#include "kernels/walk_vector.h"
#define LASIUS_OPS VectorOps
#include "kernels/walk_body.h"

namespace lasius::kernels {

const WalkTable& avx512_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels

#endif
