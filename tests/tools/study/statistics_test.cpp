#include "tools/study/statistics.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace lasius::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Quantile, IsLinearBetweenOrderStatistics) {
  const std::vector<double> values{30, 10, 20, 40};
  EXPECT_DOUBLE_EQ(quantile(values, 0), 10);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 17.5);
  EXPECT_DOUBLE_EQ(quantile(values, 1), 40);
  EXPECT_DOUBLE_EQ(quantile(std::vector<double>{1, kInfinity}, 0), 1);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, kInfinity, kInfinity}, 0.75), kInfinity);
}

/// One-sided p of all C(n + m, n) choices of ranks.
double enumerated_less(const Pair& pair) {
  std::vector<double> all = pair.a;
  all.insert(all.end(), pair.b.begin(), pair.b.end());
  const auto pairs_less = [&](unsigned chosen) {
    double count = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < all.size(); ++k)
        if ((chosen >> i & 1) != 0 && (chosen >> k & 1) == 0)
          count += all[i] < all[k] ? 1 : all[i] == all[k] ? 0.5 : 0;
    return count;
  };
  const double own = pairs_less((1u << pair.a.size()) - 1);
  double as_far = 0, choices = 0;
  for (unsigned chosen = 0; chosen < 1u << all.size(); ++chosen) {
    if (std::popcount(chosen) != static_cast<int>(pair.a.size())) continue;
    ++choices;
    as_far += pairs_less(chosen) >= own;
  }
  return as_far / choices;
}

TEST(RankTest, IsThatOfAllChoices) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    Pair pair{std::vector<double>(5), std::vector<double>(6)};
    for (auto* side : {&pair.a, &pair.b})
      for (double& v : *side) v = static_cast<double>(random() % 6);  // many ties
    pair.b[0] = kInfinity;
    EXPECT_NEAR(rank_test({&pair, 1}).less, enumerated_less(pair), 1e-12);
  }
}

// Permeability of the human chorioamnion at term and early (Hollander and Wolfe 1973, page 69).
// R: wilcox.test(x, y, alternative = "greater") gives W = 35, p-value = 0.1272.
TEST(RankTest, HollanderAndWolfe) {
  const Pair pair{{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46},
                  {1.15, 0.88, 0.90, 0.74, 1.21}};
  const RankTest t = rank_test({&pair, 1});
  EXPECT_NEAR(t.greater, 0.1272, 5e-5);
  EXPECT_NEAR(1 - t.effect, 35.0 / 50, 1e-12);
}

TEST(RankTest, OfSharesIsFishersExactTest) {
  // The lady tasting tea: 3 of 4 against 1 of 4; R: fisher.test(alternative = "greater"), 0.2429.
  const Pair tea{{1, 1, 1, 0}, {1, 0, 0, 0}};
  EXPECT_NEAR(rank_test({&tea, 1}).greater, 17.0 / 70, 1e-12);
}

TEST(RankTest, AddsUpOverQuestions) {
  const std::vector<Pair> two{{{1, 2}, {3, 4}}, {{10, 20}, {30, 40}}};
  const RankTest t = rank_test(two);
  EXPECT_NEAR(t.less, 1.0 / 36, 1e-12);
  EXPECT_DOUBLE_EQ(2 * t.less, least_rank_p(2, 2));
  EXPECT_DOUBLE_EQ(t.effect, 1);
}

TEST(RankTest, NormalLawMeetsTheExactOne) {
  std::mt19937 random(7);
  const auto draw = [&](int size) {
    std::vector<double> values;
    for (int i = 0; i < size; ++i) values.push_back(static_cast<double>(random() % 100));
    return values;
  };
  Pair pair{draw(60), draw(60)};
  for (double& v : pair.a) v -= 8;
  const double exact = rank_test({&pair, 1}).less;
  pair.b.push_back(50);
  EXPECT_NEAR(rank_test({&pair, 1}).less / exact, 1, 0.15);
}

TEST(Binomial, ByHand) {
  EXPECT_NEAR(binomial_above(9, 10, 0.5), 11.0 / 1024, 1e-12);
  EXPECT_NEAR(binomial_below(0, 3, 0.1), 0.729, 1e-12);
  EXPECT_EQ(binomial_below(3, 3, 0.1), 1);
}

// Clopper and Pearson 1934; R: binom.test(7, 10)$conf.int gives 0.3475471 0.9332605.
TEST(ShareInterval, AsInR) {
  const Interval seven = share_interval(7, 10);
  EXPECT_NEAR(seven.low, 0.3475471, 1e-6);
  EXPECT_NEAR(seven.high, 0.9332605, 1e-6);
  EXPECT_EQ(share_interval(10, 10).high, 1);
  EXPECT_NEAR(share_interval(10, 10).low, 0.6915029, 1e-6);
  EXPECT_EQ(share_interval(0, 10).low, 0);
}

TEST(ResampledInterval, CoversTheRatioOfMediansAndIsTheSameEveryTime) {
  std::mt19937 random(1);
  int covered = 0;
  for (int round = 0; round < 40; ++round) {
    Pair pair{std::vector<double>(30), std::vector<double>(30)};
    for (double& v : pair.a) v = 1 + static_cast<double>(random()) / 0x1p32;
    for (double& v : pair.b) v = 2 + 2 * static_cast<double>(random()) / 0x1p32;
    const Interval interval = resampled_interval({&pair, 1}, median_ratio);
    covered += interval.low <= 0.5 && 0.5 <= interval.high;
    const Interval again = resampled_interval({&pair, 1}, median_ratio);
    ASSERT_EQ(interval.low, again.low);
    ASSERT_EQ(interval.high, again.high);
  }
  EXPECT_GE(covered, 34);
}

TEST(MedianRatio, IsNoneWhereHalfOfTheRunsFail) {
  const Pair failing{{1, kInfinity, kInfinity}, {1, 2, 3}};
  EXPECT_TRUE(std::isnan(median_ratio({&failing, 1})));
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
