// The walk kernels by instruction set, each table in a source of its own.
#pragma once

#include "kernels/walk/walk.h"

namespace lasius::kernels {

const WalkTable& scalar_walk_table() noexcept;
#if defined(__x86_64__)
const WalkTable& avx2_walk_table() noexcept;
const WalkTable& avx512_walk_table() noexcept;
#endif

}  // namespace lasius::kernels
