// The walk in plain C++: the specification that the others must match bit for bit.

#include <span>

#include "kernels/walk/walk_tables.h"

namespace lasius::kernels {
namespace {

struct ScalarOps {
  /// Steps that ants take in lock-step: none.
  template <int kLanes, bool kMixture, bool kFactor, Draw kDraw>
  static int lockstep(const WalkWorld&, std::span<WalkSlot* const>, int) noexcept {
    return 0;
  }

  /// One draw from a row: choose a rule, mask closed moves, spin the roulette wheel.
  /// Prefix sums follow the tree of the vector code: by pairs, by fours, the lower four's total
  /// onto the upper four, the total of eight onto the next eight.
  template <int kLanes, bool kMixture, bool kFactor>
  [[gnu::always_inline]] static int roulette(const WalkWorld& world, const float* row,
                                             std::uint32_t open, std::uint32_t previous,
                                             std::uint32_t random) noexcept {
    int rule = random < world.rule_start[kPheromoneRule] ? kGreedyRule : kCombinedRule;
    if constexpr (kMixture) {
      rule = (random >= world.rule_start[kPheromoneRule]) +
             (random >= world.rule_start[kDistanceRule]) +
             (random >= world.rule_start[kCombinedRule]);
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
    if (rule == kGreedyRule) {
      int best = -1;
      for (int k = 0; k < kLanes; ++k) {
        if (weight[k] > (best < 0 ? 0.0f : weight[best])) best = k;
      }
      return best;
    }
    for (int base = 0; base < kLanes; base += 4) {
      float* s = sum + base;
      const float pairs[4] = {s[0], s[1] + s[0], s[2] + s[1], s[3] + s[2]};
      s[0] = pairs[0];
      s[1] = pairs[1];
      s[2] = pairs[2] + pairs[0];
      s[3] = pairs[3] + pairs[1];
    }
    for (int base = 0; base + 8 <= kLanes; base += 8) {
      for (int k = base + 4; k < base + 8; ++k) sum[k] += sum[base + 3];
      if (base == 0) continue;
      const float before = sum[base - 1];
      for (int k = base; k < base + 8; ++k) sum[k] += before;
    }
    const auto rest = random - static_cast<std::uint32_t>(world.rule_start[rule]);
    const float share = static_cast<float>(rest) * world.rule_scale[rule];
    const float threshold = share * sum[kLanes - 1];
    int last = -1;
    for (int k = 0; k < kLanes; ++k) {
      if (!(weight[k] > 0)) continue;
      if (threshold < sum[k]) return k;
      last = k;
    }
    return last;
  }

  /// The exponential race of Draw::discard: the move with the longest time, the first of equals.
  /// Its time is the random one at weight 1, times the mean that the row holds.
  template <int kLanes, bool kFactor>
  static int race(const WalkWorld& world, const float* row, std::uint32_t open,
                  std::uint32_t previous, const float* at_weight_one) noexcept {
    int last = -1;
    float longest = 0;
    for (int k = 0; k < kLanes; ++k) {
      const float mean = kFactor ? row[k] * world.factor[previous][k] : row[k];
      const float time = at_weight_one[k] * mean;
      if ((open >> k & 1) == 0 || !(time > longest)) continue;
      last = k;
      longest = time;
    }
    return last;
  }

  /// The bits of `word` at the set bits of `mask`, moved together (pext).
  static std::uint32_t bits_at(std::uint64_t word, std::uint64_t mask) noexcept {
    std::uint32_t bits = 0;
    for (int k = 0; mask != 0; mask &= mask - 1, ++k) {
      bits |= static_cast<std::uint32_t>((word & mask & -mask) != 0) << k;
    }
    return bits;
  }
};

}  // namespace
}  // namespace lasius::kernels

#define LASIUS_TARGET
#define LASIUS_OPS ScalarOps
#include "kernels/walk/walk_body.h"

namespace lasius::kernels {

const WalkTable& scalar_walk_table() noexcept { return kTable; }

}  // namespace lasius::kernels
