// What walk kernels are tested on: instruction sets, shapes, and the numbers that their ants draw.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/base/random_stream.h"
#include "kernels/walk/walk.h"
#include "tests/kernels/base/instruction_sets.h"

namespace lasius::kernels {

/// Those of this CPU with walk kernels of their own, the reference first.
inline std::vector<Isa> walk_isas() {
  auto isas = supported_isas();
  const auto same = [](Isa a, Isa b) { return &walk_table(a) == &walk_table(b); };
  isas.erase(std::unique(isas.begin(), isas.end(), same), isas.end());
  return isas;
}

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
  const auto block = random_words(world.seed, {index / each, ant, 0, 0});
  return std::rotl(block[index % 4], index % each < 4 ? 0 : 16);
}

}  // namespace lasius::kernels
