// The walk in plain C++: the specification that the others must match bit for bit.

#include "kernels/walk.h"

namespace lasius::kernels {
namespace {

struct ScalarOps {
  /// One draw from a row: pick a rule, mask closed moves, spin the roulette wheel.
  /// Prefix sums follow the tree of the vector code: by pairs, by fours, then the lower four's
  /// total onto the upper four.
  template <int kLanes, bool kMixture, bool kFactor>
  [[gnu::always_inline]] static int draw(const WalkWorld& world, const float* row,
                                         std::uint32_t open, std::uint32_t previous,
                                         std::uint32_t random) noexcept {
    int rule = kCombinedRule;
    float share = static_cast<float>(random) * 0x1p-32f;
    if constexpr (kMixture) {
      rule = (random >= world.rule_start[1]) + (random >= world.rule_start[2]);
      const auto rest = random - static_cast<std::uint32_t>(world.rule_start[rule]);
      share = static_cast<float>(rest) * world.rule_scale[rule];
    }
    float weight[kLanes];
    float sum[kLanes];
    for (int k = 0; k < kLanes; ++k) {
      float w = row[k];
      if constexpr (kFactor) w *= world.factor[previous][k];
      if constexpr (kMixture) {
        const float distance = row[kLanes + k];
        w = rule == kPheromoneRule ? w : rule == kDistanceRule ? distance : w * distance;
      }
      weight[k] = (open >> k & 1) != 0 ? w : 0.0f;
      sum[k] = weight[k];
    }
    for (int base = 0; base < kLanes; base += 4) {
      float* s = sum + base;
      const float pairs[4] = {s[0], s[1] + s[0], s[2] + s[1], s[3] + s[2]};
      s[0] = pairs[0];
      s[1] = pairs[1];
      s[2] = pairs[2] + pairs[0];
      s[3] = pairs[3] + pairs[1];
    }
    if constexpr (kLanes == 8) {
      for (int k = 4; k < 8; ++k) sum[k] += sum[3];
    }
    const float threshold = share * sum[kLanes - 1];
    int last = -1;
    for (int k = 0; k < kLanes; ++k) {
      if (!(weight[k] > 0)) continue;
      if (threshold < sum[k]) return k;
      last = k;
    }
    return last;
  }
};

}  // namespace
}  // namespace lasius::kernels

#define LASIUS_TARGET
#define LASIUS_OPS ScalarOps
#include "kernels/walk_body.h"

namespace lasius::kernels {

const WalkTable& scalar_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels
