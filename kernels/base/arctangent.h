// Angles from IEEE operations only: every machine and compiler agrees bit for bit.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "kernels/base/horner.h"

namespace lasius::kernels {

/// The angle of a vector (x, y) from the x axis, for x, y >= 0, not both 0 and neither above
/// 10^100: in [0, pi/2], exactly 0 and pi/2 on the axes; off by less than 3 * 2^-53 of itself. The
/// angle of the nearest multiple of 1/8 of the slope, from a table, and Taylor's series for the
/// rest.
inline double quadrant_angle(double x, double y) noexcept {
  struct Split {
    double high, low;
  };
  constexpr Split kAngles[] = {{0, 0},
                               {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                               {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                               {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                               {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                               {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                               {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                               {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                               {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
  constexpr Split kQuarterTurn{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
  const bool steep = y > x;
  if (steep) std::swap(x, y);
  const int eighths = static_cast<int>((16 * (y / x) + 1) / 2);
  const double c = eighths * 0.125;
  const double t = (y - c * x) / (x + c * y);
  const double z = t * t;
  const double series =
      horner(z, 1.0 / 13, -1.0 / 11, 1.0 / 9, -1.0 / 7, 1.0 / 5, -1.0 / 3) * z * t;
  const Split& near = kAngles[eighths];
  if (!steep) return near.high + (t + (series + near.low));
  return (kQuarterTurn.high - near.high) - (t + (series + (near.low - kQuarterTurn.low)));
}

/// The angle of (x, y) from the x axis, in [-pi, pi]; 0 at the origin.
inline double direction(double y, double x) noexcept {
  const double wide = std::fabs(x), high = std::fabs(y);
  if (wide == 0 && high == 0) return 0;
  double angle = quadrant_angle(wide, high);
  if (x < 0) angle = std::numbers::pi - angle;
  return y < 0 ? -angle : angle;
}
/// Of [-1, 1].
inline double arc_cosine(double c) noexcept { return direction(std::sqrt((1 - c) * (1 + c)), c); }
inline double arc_sine(double s) noexcept { return direction(s, std::sqrt((1 - s) * (1 + s))); }

}  // namespace lasius::kernels
