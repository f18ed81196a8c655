// Octile lengths as 32-bit integers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "lasius/grid/geometry.h"

namespace lasius::peers {

/// Costs of the moves whose ratio is a convergent of sqrt 2. Integers make equal lengths equal,
/// which rounding does not: ties are broken as meant, and plateaus are not searched.
struct OctileCosts {
  std::uint32_t straight, diagonal;

  /// Octile distance between two cells.
  std::uint32_t distance(int x, int y, Cell goal) const noexcept {
    const auto dx = static_cast<std::uint32_t>(std::abs(x - goal.x));
    const auto dy = static_cast<std::uint32_t>(std::abs(y - goal.y));
    return straight * std::max(dx, dy) + (diagonal - straight) * std::min(dx, dy);
  }
};

/// The finest first; 32 bits hold 1.8, 25 and 358 million cells. A search whose costs pass
/// kCostLimit starts again with the next.
inline constexpr std::array<OctileCosts, 3> kOctileCosts = {{{2378, 3363}, {169, 239}, {12, 17}}};
inline constexpr std::uint32_t kCostLimit = ~std::uint32_t{0} - (1u << 16);

}  // namespace lasius::peers
