// Subgradient ascent, as all bounds of tours take it (Held, Wolfe & Crowder 1974).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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

/// Of climb(), whose lambda goes from kFirstClimb to kLastClimb.
struct ClimbPace {
  double newest;  ///< the newest subgradient's share in their running mean
  int patience;   ///< values without gain before lambda falls
  double fall;    ///< to this share of it
};
constexpr double kFirstClimb = 1, kMostClimb = 2, kLastClimb = 0.01, kClimbRise = 1.1;

/// The volume algorithm (Barahona & Anbil 2000), which needs a quarter of the values of ascend()
/// where many solutions are nearly best: steps of lambda (upper - greatest) / |mean|^2 from the
/// prices of the greatest value, along the mean of the subgradients. `dual` has value(), kFar where
/// it is stopped; keep(), of its prices, and back(), to those kept; subgradient(); squares() of a
/// mean; and stand(step, mean), that far along it from the prices kept.
template <class Dual>
void climb(Dual& dual, Sum upper, const ClimbPace& pace) {
  Sum greatest = dual.value();
  if (greatest >= kFar) return;
  dual.keep();
  std::vector<double> mean = dual.subgradient();
  int idle = 0;
  for (double lambda = kFirstClimb; lambda > kLastClimb && greatest < upper;) {
    const double squares = dual.squares(mean);
    if (squares == 0) break;
    dual.stand(lambda * static_cast<double>(upper - greatest) / squares, mean);
    const Sum value = dual.value();
    if (value >= kFar) break;
    const std::vector<double>& newest = dual.subgradient();
    double along = 0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      along += mean[i] * newest[i];
      mean[i] += pace.newest * (newest[i] - mean[i]);
    }
    if (value > greatest) {
      greatest = value;
      dual.keep();
      idle = 0;
      if (along > 0) lambda = std::min(kMostClimb, kClimbRise * lambda);
    } else if (++idle == pace.patience) {
      idle = 0;
      lambda *= pace.fall;
    }
  }
  dual.back();
}

}  // namespace lasius::tour
