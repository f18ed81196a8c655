// The pseudo-random proportional rule over any number of choices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lasius::kernels {

/// With probability `greedy` the choice of the largest weight, the first of equals; else one drawn
/// in proportion to the weights (Dorigo & Gambardella 1997, eq. 3). One random word decides both:
/// it is spun on a wheel whose first share is the greedy one. The walk kernel applies the same rule
/// to rows of at most 32 moves of a grid.
///   weights  at least 0; 0 is a choice that is closed
///   greedy   0 .. 1
/// Returns the index of the choice, -1 when all are closed.
inline int proportional_choice(std::span<const double> weights, double greedy,
                               std::uint32_t word) noexcept {
  const double spun = word * 0x1p-32;
  if (spun < greedy) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < weights.size(); ++k) {
      if (weights[k] > weights[best]) best = k;
    }
    return !weights.empty() && weights[best] > 0 ? static_cast<int>(best) : -1;
  }
  double total = 0;
  for (const double w : weights) total += w;
  const double threshold = (spun - greedy) / (1 - greedy) * total;
  double sum = 0;
  int last = -1;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (!(weights[k] > 0)) continue;
    last = static_cast<int>(k);
    sum += weights[k];
    if (threshold < sum) return last;
  }
  return last;  // rounding at the end of the wheel
}

}  // namespace lasius::kernels
