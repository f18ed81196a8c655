// A grid as the kernels see it.
#pragma once

#include <cstdint>

#include "kernels/sight/views.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Memory of its bitmap, border and all.
inline std::int64_t bitmap_bytes(const Grid& grid) noexcept {
  return std::int64_t{grid.stride()} * (grid.height() + 2) * 8;
}

inline kernels::BitmapView view_of(const Grid& grid) noexcept {
  return {grid.row(0), grid.stride(), grid.width(), grid.height()};
}

}  // namespace lasius
