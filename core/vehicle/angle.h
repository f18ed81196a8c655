// Angles from IEEE operations only, so that every machine and compiler agrees bit for bit.
#pragma once

#include <cmath>
#include <numbers>

#include "kernels/base/arctangent.h"
#include "kernels/base/sine.h"

namespace lasius::vehicle {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2 * kPi;

using kernels::arc_cosine;
using kernels::arc_sine;
using kernels::direction;

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
