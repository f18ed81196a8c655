// The statistics of the studies: small, exact where they can be, the same on every machine.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lasius::study {

/// The quantile `share` in [0, 1], linear between the order statistics (type 7 of Hyndman and Fan
/// 1996). Values may be infinite. Precondition: not empty.
double quantile(std::span<const double> values, double share);

/// Ranks from 1, doubled so that mean ranks of ties are whole; values that differ by less than a
/// rounding are ties. Values may be infinite.
std::vector<int> doubled_ranks(std::vector<double> values);

struct Interval {
  double low = 0;
  double high = 0;
};

/// " [0.25, 0.50]".
std::string interval_text(const Interval& interval, int decimals);

/// Independent runs of two contenders on one question.
struct Pair {
  std::vector<double> a, b;
};

/// Mann and Whitney's test (1947) that values of a are less than those of b, in the sum over
/// questions: exact for the ranks at hand, ties at their mean rank, up to 120 values, else by the
/// normal law. On values of 0 and 1 it is Fisher's exact test. Values may be infinite.
struct RankTest {
  double less = 1;      ///< one-sided p: small where a is less
  double greater = 1;   ///< small where a is greater
  double effect = 0.5;  ///< Vargha and Delaney's A12 (2000): share of pairs in which a is less,
                        ///< ties counted half; mean over the questions
};
RankTest rank_test(std::span<const Pair> questions);

/// RankTest::effect alone.
double share_less(std::span<const Pair> questions);

/// The least two-sided p that the test can give, for samples of `seeds` without ties.
double least_rank_p(int questions, int seeds);

/// P(X <= k) and P(X >= k) of a binomial law.
double binomial_below(int k, int n, double p);
double binomial_above(int k, int n, double p);

/// 95% interval of a share, k of n (Clopper and Pearson 1934). Precondition: 0 <= k <= n, n > 0.
Interval share_interval(int k, int n);

/// A figure of resampled questions.
using Figure95 = std::function<double(std::span<const Pair>)>;
/// 95% interval: percentiles of the figure over 2000 resamplings, runs drawn within contender and
/// question (Efron 1979), from a counter-based stream: equal samples give equal intervals.
Interval resampled_interval(std::span<const Pair> questions, const Figure95& figure);

/// Ratio of the medians of a and b, the geometric mean over the questions; NaN where a median is
/// not finite or not above 0.
double median_ratio(std::span<const Pair> questions);

/// p values adjusted for their number by Holm's step-down method (1979), in the given order.
std::vector<double> holm(std::span<const double> p);

}  // namespace lasius::study
