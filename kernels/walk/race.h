// Random times with an exponential distribution, by which Draw::discard draws (walk.h).
#pragma once

#include <bit>
#include <cstdint>

namespace lasius::kernels {

/// A random word as its second use reads it.
constexpr std::uint32_t turned(std::uint32_t word) noexcept { return std::rotl(word, 16); }

/// -log2 of a random number read as one between 0 and 1, error below 5e-6; positive. IEEE
/// operations without a branch or a division, so that loops over it vectorise and every machine
/// agrees.
[[gnu::always_inline]] inline float minus_log2(std::uint32_t number) noexcept {
  const auto u = static_cast<float>(static_cast<std::int32_t>(number >> 8 | 1));  // of 2^24
  const auto bits = std::bit_cast<std::int32_t>(u);
  constexpr std::int32_t kLast = 0x4b7fffff;  // of the floats below 2^24
  const auto octaves = static_cast<float>((kLast - bits) >> 23);
  const float m = std::bit_cast<float>((bits & 0x7fffff) | 0x3f800000);
  // 1 - log2(m) within 1.9e-6 (Sollya: fpminimax(1 - log2(x), 6, [|SG...|], [1; 2], absolute)).
  float p = 0.02567711286246776580810546875f;
  p = p * m - 0.2750270068645477294921875f;
  p = p * m + 1.26648080348968505859375f;
  p = p * m - 3.285699367523193359375f;
  p = p * m + 5.341114044189453125f;
  p = p * m - 6.112475872039794921875f;
  return octaves + (p * m + 4.039928436279296875f);
}

}  // namespace lasius::kernels
