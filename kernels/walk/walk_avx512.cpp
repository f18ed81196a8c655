// The walk with AVX-512: eight ants abreast where a row is eight weights; else one by one with its
// masks, on registers of AVX2's width.

#include "kernels/walk/walk_tables.h"

#if defined(__x86_64__)

#if !defined(__clang__)
// GCC bug 105593: its own intrinsics start from a register that they leave undefined.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif

#define LASIUS_TARGET [[gnu::target("avx512f,avx512vl,avx512dq,avx512bw,bmi,bmi2")]]
#define LASIUS_MASKS 1
#include "kernels/walk/abreast_avx512.h"
#include "kernels/walk/walk_vector.h"
// After both.
#include "kernels/walk/walk_abreast.h"
#define LASIUS_OPS AbreastOps
#include "kernels/walk/walk_body.h"

namespace lasius::kernels {

const WalkTable& avx512_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels

#endif
