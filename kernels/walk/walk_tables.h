// The walk kernels by instruction set, each table in a source of its own.
#pragma once

#include <span>

#include "kernels/walk/walk.h"

namespace lasius::kernels {

/// Of kernels whose ants step one by one.
struct InTurnOps {
  /// Steps that ants do abreast: none.
  template <int kLanes, bool kMixture, bool kFactor, Draw kDraw>
  static int abreast(const WalkWorld&, std::span<WalkSlot* const>, int) noexcept {
    return 0;
  }
};

const WalkTable& scalar_walk_table() noexcept;
#if defined(__x86_64__)
const WalkTable& avx2_walk_table() noexcept;
const WalkTable& avx512_walk_table() noexcept;
#endif

}  // namespace lasius::kernels
