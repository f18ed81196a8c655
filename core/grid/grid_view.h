// A grid as the kernels see it.
#pragma once

#include "kernels/sight/views.h"
#include "lasius/grid.h"

namespace lasius {

inline kernels::BitmapView view_of(const Grid& grid) noexcept {
  return {grid.row(0), grid.stride(), grid.width(), grid.height()};
}

}  // namespace lasius
