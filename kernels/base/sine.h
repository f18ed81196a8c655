// Sine and cosine from IEEE operations only, so that every machine and compiler agrees bit for bit.
#pragma once

#include <cstdint>

#include "kernels/base/horner.h"

namespace lasius::kernels {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// sin x and cos x for |x| <= 10^6; error below 1e-15. Reduction by pi/2 in three parts (Cody &
/// Waite), then Taylor's series on [-pi/4, pi/4].
inline SineCosine sine_cosine(double x) noexcept {
  constexpr double kShift = 0x1.8p52;  // adding it rounds to a whole number
  const double turns = (x * 0.63661977236758134308 + kShift) - kShift;
  const double r = ((x - turns * 1.57079632673412561417) - turns * 6.07710050630396597660e-11) -
                   turns * 2.02226624879595063154e-21;
  const double z = r * r;
  double s = horner(z, 1.0 / 355687428096000, -1.0 / 1307674368000, 1.0 / 6227020800,
                    -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6);
  s = r + r * z * s;
  double c = horner(z, 1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800,
                    1.0 / 40320, -1.0 / 720, 1.0 / 24);
  c = 1 - z * 0.5 + z * z * c;
  switch (static_cast<std::int64_t>(turns) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace lasius::kernels
