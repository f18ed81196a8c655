// What walk kernels are tested on: their shapes, and the numbers that their ants draw.
#pragma once

#include <Random123/philox.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/walk/walk.h"

namespace lasius::kernels {

/// Every shape that a kernel is compiled for.
inline std::vector<WalkShape> all_shapes() {
  std::vector<WalkShape> shapes;
  for (const int lanes : {4, 8, 16, 24, 32}) {
    for (const bool factor : {false, true}) {
      shapes.push_back({lanes, false, factor, Draw::roulette});
      shapes.push_back({lanes, true, factor, Draw::roulette});
      shapes.push_back({lanes, false, factor, Draw::discard});
    }
  }
  return shapes;
}

inline std::string name(WalkShape s) {
  return std::to_string(s.lanes) + (s.mixture ? "mixture" : "single") + (s.factor ? "factor" : "") +
         (s.draw == Draw::discard ? "discard" : "");
}

/// Number `index` of an ant in iteration 0, as WalkSlot says.
inline std::uint32_t number_of(const WalkWorld& world, Draw draw, std::uint32_t ant,
                               std::uint32_t index) {
  const std::uint32_t each = draw == Draw::discard ? 8 : 4;
  const auto block = r123::Philox4x32()(
      {{index / each, ant, 0, 0}},
      {{static_cast<std::uint32_t>(world.seed), static_cast<std::uint32_t>(world.seed >> 32)}});
  return std::rotl(block[index % 4], index % each < 4 ? 0 : 16);
}

}  // namespace lasius::kernels
