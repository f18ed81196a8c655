// Exponential times for the discard roulette, which is a race.
#pragma once

#include <bit>
#include <cstdint>

namespace lasius::kernels {

/// -log2 of a random word read as a number in (0, 1], error below 1e-6 of its value + 1e-7. IEEE
/// operations without a branch, so that loops over it vectorise and every machine agrees.
[[gnu::always_inline]] inline float minus_log2(std::uint32_t word) noexcept {
  // Odd, so never 0. From 2^24 on the conversion rounds, to 1 at most.
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

}  // namespace lasius::kernels
