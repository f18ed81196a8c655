#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Summary, ByHand) {
  const Summary s = summarise(std::vector<double>{4, 1, 3, 2});
  EXPECT_EQ(s.count, 4);
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt(5.0 / 3));  // (2.25 + 0.25 + 0.25 + 2.25) / 3
  EXPECT_DOUBLE_EQ(s.least, 1);
  EXPECT_DOUBLE_EQ(s.median, 2.5);
  EXPECT_DOUBLE_EQ(s.most, 4);
  EXPECT_EQ(summarise({}).count, 0);
  EXPECT_EQ(summarise(std::vector<double>{7}).sd, 0);
}

TEST(Quantile, IsLinearBetweenOrderStatistics) {
  const std::vector<double> values{30, 10, 20, 40};
  EXPECT_DOUBLE_EQ(quantile(values, 0), 10);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 17.5);
  EXPECT_DOUBLE_EQ(quantile(values, 1), 40);
  EXPECT_DOUBLE_EQ(quantile(std::vector<double>{1, kInfinity}, 0), 1);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, kInfinity, kInfinity}, 0.75), kInfinity);
}

// Darwin's maize: crossed minus self-fertilised plants, eighths of an inch (Fisher 1935, section
// 17). R: wilcox.test(d) gives V = 96, p-value = 0.04126.
TEST(SignedRank, DarwinsMaize) {
  const SignedRank t =
      signed_rank(std::vector<double>{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48});
  EXPECT_EQ(t.pairs, 15);
  EXPECT_EQ(t.plus, 96);
  EXPECT_EQ(t.minus, 24);
  EXPECT_NEAR(t.p, 0.04126, 5e-6);
  EXPECT_DOUBLE_EQ(t.effect, 0.6);
}

// Depression scale of nine patients (Hollander and Wolfe 1973, table 3.1): V = 40, one-sided
// p = 0.01953, of 512 sign patterns.
TEST(SignedRank, HollanderAndWolfe) {
  const double x[] = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const double y[] = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> d;
  for (int i = 0; i < 9; ++i) d.push_back(x[i] - y[i]);
  const SignedRank t = signed_rank(d);
  EXPECT_EQ(t.plus, 40);
  EXPECT_DOUBLE_EQ(t.p, 20.0 / 512);
}

TEST(SignedRank, TiesTakeMeanRanksAndZerosAreDropped) {
  // |d| = 1, 1, 2: ranks 1.5, 1.5, 3. Sums of the positive ones over the 8 sign patterns: 0, 1.5,
  // 1.5, 3, 3, 4.5, 4.5, 6; 1.5 and less has share 3/8.
  const SignedRank t = signed_rank(std::vector<double>{0, 1, -1, -2, 0});
  EXPECT_EQ(t.pairs, 3);
  EXPECT_EQ(t.plus, 1.5);
  EXPECT_EQ(t.minus, 4.5);
  EXPECT_DOUBLE_EQ(t.p, 0.75);
  EXPECT_DOUBLE_EQ(t.effect, -0.5);
}

TEST(SignedRank, InfiniteDifferencesRankHighest) {
  const SignedRank t = signed_rank(std::vector<double>{-kInfinity, 1, 2, 3});
  EXPECT_EQ(t.minus, 4);
  EXPECT_EQ(t.plus, 6);
  const SignedRank tied = signed_rank(std::vector<double>{-kInfinity, kInfinity});
  EXPECT_EQ(tied.plus, 1.5);
  EXPECT_EQ(tied.p, 1);
}

TEST(SignedRank, NothingDiffers) {
  const SignedRank t = signed_rank(std::vector<double>{0, 0});
  EXPECT_EQ(t.pairs, 0);
  EXPECT_EQ(t.p, 1);
  EXPECT_EQ(t.effect, 0);
}

TEST(SignedRank, AllOfSixPointOneWay) {
  // The least p of n pairs is 2 / 2^n: five pairs never reach 5%.
  EXPECT_DOUBLE_EQ(signed_rank(std::vector<double>{1, 2, 3, 4, 5}).p, 2.0 / 32);
  EXPECT_DOUBLE_EQ(signed_rank(std::vector<double>{1, 2, 3, 4, 5, 6}).p, 2.0 / 64);
}

TEST(SignedRank, NormalLawMeetsTheExactOne) {
  std::mt19937 random(7);
  std::vector<double> d;
  for (int i = 0; i < 200; ++i)
    d.push_back((random() % 2 != 0 ? 1 : -0.9) * (1.0 + static_cast<double>(random() % 1000)));
  const double exact = signed_rank(d).p;
  ASSERT_GT(exact, 0.01);
  d.push_back(1.5);
  EXPECT_NEAR(signed_rank(d).p / exact, 1, 0.1);
}

TEST(MeanInterval, CoversTheMeanOfAKnownLaw) {
  // 200 samples of 25 uniform numbers: about 95% of the intervals hold 1/2, a little fewer for the
  // percentile method at this size.
  std::mt19937 random(1);
  int covered = 0;
  for (int sample = 0; sample < 200; ++sample) {
    std::vector<double> values;
    for (int i = 0; i < 25; ++i) values.push_back(static_cast<double>(random()) / 0x1p32);
    const Interval interval = mean_interval(values);
    ASSERT_LT(interval.low, interval.high);
    covered += interval.low <= 0.5 && 0.5 <= interval.high;
  }
  EXPECT_GE(covered, 176);
  EXPECT_LE(covered, 199);
}

TEST(MeanInterval, IsTheSameEveryTime) {
  const std::vector<double> values{1, 5, 2, 8, 4};
  const Interval a = mean_interval(values), b = mean_interval(values);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  const Interval one = mean_interval(std::vector<double>{3});
  EXPECT_EQ(one.low, 3);
  EXPECT_EQ(one.high, 3);
}

TEST(Holm, StepsDown) {
  const auto p = holm(std::vector<double>{0.01, 0.04, 0.03, 0.5});
  EXPECT_DOUBLE_EQ(p[0], 0.04);
  EXPECT_DOUBLE_EQ(p[1], 0.09);  // not below the one before it
  EXPECT_DOUBLE_EQ(p[2], 0.09);
  EXPECT_DOUBLE_EQ(p[3], 0.5);
}

}  // namespace
}  // namespace lasius::study
