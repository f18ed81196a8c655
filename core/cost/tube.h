// The cells near a walk.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cost/edge_field.h"
#include "core/cost/terrain.h"

namespace lasius::cost {

/// Keeps marching within some cells of a walk: beyond these nothing is left to be hoped for. No
/// bound, and not to be certified by.
class Tube final : public EdgeField::Bound {
 public:
  /// @param reach  cells, along either axis
  Tube(const Terrain& terrain, std::span<const Cell> walk, int reach)
      : terrain_(terrain),
        near_(static_cast<std::size_t>(terrain.stride()) * (terrain.height() + 2)) {
    for (const Cell c : walk) {
      const int first = std::max(c.x - reach, 0), last = std::min(c.x + reach, terrain.width() - 1);
      const int low = std::max(c.y - reach, 0), high = std::min(c.y + reach, terrain.height() - 1);
      for (int y = low; y <= high; ++y)
        std::fill_n(near_.begin() + static_cast<std::ptrdiff_t>(terrain.index(first, y)),
                    last - first + 1, std::uint8_t{1});
    }
  }
  double at(Point, Cell cell) const override {
    return near_[terrain_.index(cell.x, cell.y)] != 0 ? 0 : kInfinity;
  }

 private:
  const Terrain& terrain_;
  std::vector<std::uint8_t> near_;
};

}  // namespace lasius::cost
