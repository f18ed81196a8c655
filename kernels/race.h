// The discard roulette as a race of exponential times.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace lasius::kernels {

/// -log2 of a random word read as a number in (0, 1], error below 1e-6 of its value + 1e-7. IEEE
/// operations without a branch, so that loops over it vectorise and every machine agrees.
[[gnu::always_inline]] inline float minus_log2(std::uint32_t word) noexcept {
  // 24 bits, so that the conversion is exact and never 0.
  const auto u = static_cast<float>(static_cast<std::int32_t>(word >> 8) * 2 + 1);  // of 2^25
  const auto bits = std::bit_cast<std::int32_t>(u);
  const std::int32_t centred = bits - 0x3f3504f3;  // sqrt(1/2): mantissas around 1
  const auto exponent = static_cast<float>(centred >> 23);
  const float m = std::bit_cast<float>((centred & 0x7fffff) + 0x3f3504f3);
  const float s = (m - 1) / (m + 1);
  const float z = s * s;
  float p = 1.0f / 9;
  p = p * z + 1.0f / 7;
  p = p * z + 1.0f / 5;
  p = p * z + 1.0f / 3;
  p = p * z + 1.0f;
  return (25.0f - exponent) - p * s * 2.885390082f;  // 2 / ln 2
}

/// The move that is discarded last: times -log(u) / weight, the largest wins, the first of equals.
/// -1 if no open move has a weight. `factor` is read with kFactor only.
template <int kLanes, bool kFactor>
[[gnu::always_inline]] inline int last_of_race(const float* row, const float* factor,
                                               std::uint32_t open,
                                               const std::uint32_t* random) noexcept {
  float time[kLanes];
  for (int k = 0; k < kLanes; ++k) {
    const float weight = kFactor ? row[k] * factor[k] : row[k];
    const bool runs = (open >> k & 1) != 0 && weight > 0;
    time[k] = runs ? minus_log2(random[k]) / weight : -1.0f;
  }
  int last = 0;
  for (int k = 1; k < kLanes; ++k) {
    if (time[k] > time[last]) last = k;
  }
  return time[last] < 0 ? -1 : last;
}

}  // namespace lasius::kernels
