// The walk with AVX2: eight ants abreast where there are at most eight moves; else one by one.

#include "kernels/walk/walk_tables.h"

#if defined(__x86_64__)

#define LASIUS_TARGET [[gnu::target("avx2,bmi,bmi2")]]
#define LASIUS_MASKS 0
#include "kernels/walk/abreast_avx2.h"
#include "kernels/walk/walk_vector.h"
// After both.
#include "kernels/walk/walk_abreast.h"
#define LASIUS_OPS AbreastOps
#include "kernels/walk/walk_body.h"

namespace lasius::kernels {

const WalkTable& avx2_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels

#endif
