// The statistics of the studies: small, exact where they can be, the same on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lasius::study {

/// Location and spread of a sample of finite values.
struct Summary {
  int count = 0;
  double mean = 0;
  double sd = 0;  ///< with count - 1; 0 for a single value
  double least = 0;
  double median = 0;
  double most = 0;
};
Summary summarise(std::span<const double> values);

/// The quantile `share` in [0, 1], linear between the order statistics (type 7 of Hyndman and Fan
/// 1996). Precondition: not empty.
double quantile(std::span<const double> values, double share);

struct Interval {
  double low = 0;
  double high = 0;
};

/// 95% interval of the mean: percentiles of 10 000 resampled means (Efron 1979), seeded, so that
/// equal samples give equal intervals. Precondition: not empty; one value gives no width.
Interval mean_interval(std::span<const double> values);

/// Wilcoxon's signed-rank test of paired differences against a median of 0, two-sided.
struct SignedRank {
  int pairs = 0;      ///< differences that are not 0; zeros are dropped (Wilcoxon 1945)
  double plus = 0;    ///< sum of the ranks of positive differences, ties at their mean rank
  double minus = 0;   ///< the same of negative ones
  double p = 1;       ///< exact for the ranks at hand up to 200 pairs, else by the normal law
  double effect = 0;  ///< matched-pairs rank biserial (plus - minus) / (plus + minus)
};
/// Differences may be infinite: larger than every finite one. None may be NaN.
SignedRank signed_rank(std::span<const double> differences);

/// p values adjusted for their number by Holm's step-down method (1979), in the given order.
std::vector<double> holm(std::span<const double> p);

}  // namespace lasius::study
