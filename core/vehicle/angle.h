// Angles from IEEE operations only, so that every machine and compiler agrees bit for bit.
#pragma once

#include <cmath>

#include "kernels/base/arctangent.h"
#include "kernels/base/sine.h"

namespace lasius::vehicle {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kTurn = 2 * kPi;

/// The angle of (x, y) from the x axis, in [-pi, pi]; 0 at the origin.
inline double direction(double y, double x) noexcept {
  const double wide = std::fabs(x);
  const double high = std::fabs(y);
  if (wide == 0 && high == 0) return 0;
  double angle = kernels::quadrant_angle(wide, high);
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}
inline double arc_cosine(double c) noexcept { return direction(std::sqrt((1 - c) * (1 + c)), c); }
inline double arc_sine(double s) noexcept { return direction(s, std::sqrt((1 - s) * (1 + s))); }

/// In [-pi, pi], to the last digit: 2 pi in three parts (Cody & Waite). |angle| at most 10^6.
inline double half_turned(double angle) noexcept {
  const double turns = std::nearbyint(angle * (1 / kTurn));
  return ((angle - turns * (4 * 1.57079632673412561417)) -
          turns * (4 * 6.07710050630396597660e-11)) -
         turns * (4 * 2.02226624879595063154e-21);
}
/// In [0, 2 pi); what is a rounding error below a turn is 0.
inline double turned(double angle) noexcept {
  const double rest = angle - kTurn * std::floor(angle * (1 / kTurn));
  return rest < 0 || rest > kTurn - 5e-10 ? 0 : rest;
}

}  // namespace lasius::vehicle
