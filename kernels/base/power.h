// x^a from IEEE operations only, the same on every machine, compiler and vector width.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "kernels/base/horner.h"

namespace lasius::kernels {

/// log2 of a normal x > 0, by the series of artanh on [sqrt(1/2), sqrt(2)).
[[gnu::always_inline]] inline double log2_of(double x) noexcept {
  constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  // Centre the exponent so that the mantissa m lies in [sqrt(1/2), sqrt(2)).
  const std::uint64_t centred = bits + (0x3ff0000000000000ULL - 0x3fe6a09e667f3bcdULL);
  const double m = std::bit_cast<double>((centred & kMantissa) + 0x3fe6a09e667f3bcdULL);
  const double exponent =
      std::bit_cast<double>((centred >> 52) | 0x4330000000000000ULL) - (0x1p52 + 1023);
  const double s = (m - 1) / (m + 1);
  const double z = s * s;
  const double p = horner(z, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0);
  return exponent + (p * s) * 2.8853900817779268147;  // 2 / ln 2
}

/// x^a for normal x > 0, in double; 2^-1000 below that and 2^1000 above. Relative error below 1e-12
/// for |a| <= 64, below 3e-11 for any a: the series leaves 1.7e-14 of log2, times a. log2 by the
/// series of artanh on [sqrt(1/2), sqrt(2)), exp2 by Taylor's on [-1/2, 1/2]; without a branch, so
/// that loops over it vectorise.
[[gnu::always_inline]] inline double power(double x, double a) noexcept {
  constexpr double kShift = 0x1.8p52;  // adding it rounds to an integer in the low mantissa bits
  const double log2_x = log2_of(x);

  // Beyond 1023 the exponent would wrap round. Magnitudes compare as integers: compilers keep a
  // choice between doubles as a branch, since comparing them may trap.
  constexpr auto kMost = std::bit_cast<std::int64_t>(1000.0);
  constexpr auto kMagnitude = std::numeric_limits<std::int64_t>::max();
  const auto unbounded = std::bit_cast<std::int64_t>(a * log2_x);
  const std::int64_t magnitude = unbounded & kMagnitude;
  const double y =
      std::bit_cast<double>((magnitude < kMost ? magnitude : kMost) | (unbounded & ~kMagnitude));
  const double rounded = y + kShift;
  const double f = (y - (rounded - kShift)) * 0.69314718055994530942;
  const double e =
      horner(f, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320,
             1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(e) +
                               (std::bit_cast<std::uint64_t>(rounded) << 52));
}

/// Angle between two vectors of whole numbers, in radians, in [0, pi]; 0 if one is zero. From
/// IEEE operations only; error below 1e-13.
inline double angle_between(double ax, double ay, double bx, double by) noexcept {
  constexpr double kPi = 3.14159265358979323846;
  double along = ax * bx + ay * by, across = ax * by - ay * bx;
  across = across < 0 ? -across : across;
  if (along == 0 && across == 0) return 0;
  // atan2(across, along): fold into the first octant, then halve twice onto |t| < tan(pi / 16).
  const bool obtuse = along < 0;
  along = obtuse ? -along : along;
  const bool steep = across > along;
  double t = steep ? along / across : across / along;
  for (int i = 0; i < 2; ++i) t = t / (1 + __builtin_sqrt(1 + t * t));
  const double z = t * t;
  double p = 0;
  for (int n = 21; n >= 1; n -= 2) p = 1.0 / n - z * p;
  double angle = 4 * t * p;
  if (steep) angle = kPi / 2 - angle;
  return obtuse ? kPi - angle : angle;
}

}  // namespace lasius::kernels
