// Subgradient ascent, as all bounds of tours take it (Held, Wolfe & Crowder 1974).
#pragma once

#include <cstdint>
#include <limits>

namespace lasius::tour {

/// Of values and prices; scaled, so that prices have fractions.
using Sum = std::int64_t;
constexpr Sum kScale = 256;
constexpr Sum kFar = std::numeric_limits<Sum>::max() / 4;

/// Steps of lambda (upper - value) / |g|^2 along the subgradient g.
struct AscentPace {
  double first, last;  ///< lambda's
  double patience;     ///< values without gain before lambda is halved
  double most = 1e18;  ///< values in all
};

/// The greatest value above `least`, else that. `dual` has value(), kFar where it is stopped or
/// there is none; keep() and back(), of the prices of the greatest value; squares(), |g|^2; and
/// move(step), false to stop.
template <class Dual>
Sum ascend(Dual& dual, Sum upper, Sum least, const AscentPace& pace) {
  int idle = 0;
  double lambda = pace.first;
  for (int turn = 0; turn < pace.most && lambda > pace.last; ++turn) {
    const Sum value = dual.value();
    if (value >= kFar) break;
    if (value > least) {
      least = value;
      dual.keep();
      idle = 0;
    } else if (++idle >= pace.patience) {
      idle = 0;
      lambda /= 2;
      dual.back();
    }
    const double squares = dual.squares();
    if (squares == 0 || value >= upper) break;
    if (!dual.move(lambda * static_cast<double>(upper - value) / squares)) break;
  }
  return least;
}

}  // namespace lasius::tour
