#include "tools/study/tune/race.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lasius::study {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
using Blocks = std::vector<std::vector<double>>;

// Quantiles of the tables that every book has.
TEST(Laws, AreThoseOfTheTables) {
  EXPECT_NEAR(chi_square_above(3.841459, 1), 0.05, 1e-7);
  EXPECT_NEAR(chi_square_above(5.991465, 2), 0.05, 1e-7);
  EXPECT_NEAR(chi_square_above(7.814728, 3), 0.05, 1e-7);
  EXPECT_NEAR(chi_square_above(18.307038, 10), 0.05, 1e-7);
  EXPECT_NEAR(chi_square_above(21.665994, 9), 0.01, 1e-7);
  EXPECT_EQ(chi_square_above(0, 4), 1);
  EXPECT_EQ(chi_square_above(kEndless, 4), 0);
  EXPECT_NEAR(student_beyond(12.706205, 1), 0.05, 1e-7);
  EXPECT_NEAR(student_beyond(4.302653, 2), 0.05, 1e-7);
  EXPECT_NEAR(student_beyond(2.228139, 10), 0.05, 1e-7);
  EXPECT_NEAR(student_beyond(2.032245, 34), 0.05, 1e-6);
  EXPECT_NEAR(student_quantile(0.05, 33), 2.034515, 1e-6);
  EXPECT_NEAR(student_quantile(0.01, 5), 4.032143, 1e-6);
}

TEST(Ranks, TiesHaveTheirMean) {
  EXPECT_EQ(doubled_ranks({3, 1, kEndless, 1, kEndless}), (std::vector<int>{6, 3, 9, 3, 9}));
}

// Conover 1999, section 5.8: twelve homeowners rank four grasses. R = 38, 23.5, 24.5, 34; the sum
// of squared ranks is 356.5, so T = 3 * 152.5 / 56.5; two sums differ at 5% beyond
// 2.0345 * sqrt(2 * (12 * 356.5 - 3752.5) / 33) = 11.48.
TEST(FriedmansTest, OfTwelveHomeownersIsAsInTheBook) {
  const Blocks ranks{{4, 3, 2, 1},     {4, 2, 3, 1}, {3, 1.5, 1.5, 4}, {3, 1, 2, 4},
                     {4, 2, 1, 3},     {2, 2, 2, 4}, {1, 3, 2, 4},     {2, 4, 1, 3},
                     {3.5, 1, 2, 3.5}, {4, 1, 3, 2}, {4, 2, 3, 1},     {3.5, 1, 2, 3.5}};
  const Friedman test = friedman(ranks, 0.05);
  EXPECT_EQ(test.rank_sums, (std::vector<double>{38, 23.5, 24.5, 34}));
  EXPECT_NEAR(test.statistic, 3 * 152.5 / 56.5, 1e-12);
  EXPECT_NEAR(test.p, 0.0440, 5e-5);
  EXPECT_NEAR(test.critical, 2.034515 * std::sqrt(2 * (12 * 356.5 - 3752.5) / 33), 1e-4);
}

TEST(FriedmansTest, WhereAllTieNothingDiffers) {
  const Friedman test = friedman(Blocks{{1, 1, 1}, {kEndless, kEndless, kEndless}}, 0.05);
  EXPECT_EQ(test.p, 1);
  EXPECT_EQ(test.critical, kEndless);
}

TEST(FriedmansTest, WhereAllBlocksAgreeAnyDistanceCounts) {
  const Friedman test = friedman(Blocks(5, {1, 2, 3}), 0.05);
  EXPECT_NEAR(test.statistic, 10, 1e-12);  // n (m - 1)
  EXPECT_NEAR(test.p, std::exp(-5), 1e-12);
  EXPECT_NEAR(test.critical, 0, 1e-6);
}

// The subsets of the ranks 1 to 6 with a sum of at most 6 are 14 of 64.
TEST(SignedRankTest, IsCountedByHand) {
  const std::vector<double> zero(6, 0);
  EXPECT_NEAR(signed_ranks(std::vector<double>{1, 2, 3, 4, 5, -6}, zero).p, 28.0 / 64, 1e-12);
  EXPECT_NEAR(signed_ranks(std::vector<double>{1, 2, 3, 4, 5, 6}, zero).p, 2.0 / 64, 1e-12);
  EXPECT_NEAR(signed_ranks(zero, std::vector<double>{1, 2, 3, 4, 5, 6}).p, 2.0 / 64, 1e-12);
  EXPECT_EQ(signed_ranks(zero, zero).p, 1);
  EXPECT_TRUE(signed_ranks(std::vector<double>{1, 2, 3, 4, 5, -6}, zero).above);
  EXPECT_FALSE(signed_ranks(zero, std::vector<double>{1, 2, 3, 4, 5, 6}).above);
  // Ties at their mean rank: 1.5, 1.5, 3; the least sum, 0, has one subset of 8.
  EXPECT_NEAR(signed_ranks(std::vector<double>{1, 1, 2}, std::vector<double>(3, 0)).p, 0.25, 1e-12);
  // One that finds no path is worse; two are equal.
  EXPECT_NEAR(
      signed_ranks(std::vector<double>{kEndless, kEndless, 3}, std::vector<double>{1, kEndless, 2})
          .p,
      0.5, 1e-12);
}

// Of the ranks 1 to 61 the 21 at 1, 4, ..., 61 are negative and add up to 651; the mean of such a
// sum is 61 * 62 / 4 and its variance 61 * 62 * 123 / 24, so z = (945.5 - 651) / 139.22.
TEST(SignedRankTest, OfManyIsByTheNormalLaw) {
  std::vector<double> a, zero(61, 0);
  for (int i = 0; i < 61; ++i) a.push_back((i + 1) * (i % 3 == 0 ? -1 : 1));
  EXPECT_NEAR(signed_ranks(a, zero).p, 0.0344, 5e-5);
}

/// Values of a block for candidates that are left: `value(candidate)`.
template <class Value>
void run_block(Race& race, const Value& value) {
  std::vector<double> values;
  for (const std::size_t c : race.left()) values.push_back(value(c));
  race.add(values);
}

TEST(ARace, LeavesThePlantedBest) {
  Race race(6, {.first_test = 5});
  for (int block = 0; block < 30 && race.left().size() > 1; ++block)
    run_block(race, [&](std::size_t c) {
      const double noise = static_cast<double>((block * 7 + static_cast<int>(c) * 5) % 11) / 11;
      return c == 3 ? 0.05 * noise : 0.3 + noise;
    });
  EXPECT_EQ(race.left(), std::vector<std::size_t>{3});
  EXPECT_EQ(race.best(), 3U);
  for (std::size_t c = 0; c < 6; ++c) {
    if (c == 3) continue;
    EXPECT_GE(race.runners()[c].left_after, 5);
    EXPECT_LT(race.runners()[c].p, 0.05);
    EXPECT_EQ(race.runners()[c].values.size(),
              static_cast<std::size_t>(race.runners()[c].left_after));
  }
}

TEST(ARace, NobodyLeavesBeforeTheFirstTestNorWhereAllAreEqual) {
  Race early(3, {.first_test = 8}), equal(3, {.first_test = 2});
  for (int block = 0; block < 7; ++block) {
    run_block(early, [](std::size_t c) { return static_cast<double>(c); });
    run_block(equal, [](std::size_t) { return 1.0; });
  }
  EXPECT_EQ(early.left().size(), 3U);
  EXPECT_EQ(equal.left().size(), 3U);
  EXPECT_EQ(equal.best(), 0U);  // the default
  run_block(early, [](std::size_t c) { return static_cast<double>(c); });
  EXPECT_EQ(early.left(), std::vector<std::size_t>{0});
}

TEST(ARace, OfTwoTheWorseLeavesBySignedRanks) {
  Race race(2, {.first_test = 2});
  for (int block = 0; block < 5; ++block)
    run_block(race, [&](std::size_t c) { return c == 0 ? 2.0 + block : 1.0; });
  EXPECT_EQ(race.left().size(), 2U);  // 2 / 2^5 is above 0.05
  run_block(race, [](std::size_t c) { return c == 0 ? kEndless : 1.0; });
  EXPECT_EQ(race.left(), std::vector<std::size_t>{1});
  EXPECT_NEAR(race.runners()[0].p, 2.0 / 64, 1e-12);
}

TEST(ARace, StandingsHaveTheBestFirstAndIntervals) {
  Race race(3, {.first_test = 50});
  for (int block = 0; block < 10; ++block)
    run_block(race, [&](std::size_t c) {
      return std::vector<double>{2, block % 3 == 0 ? 3.0 : 1.0, 4}[c];
    });
  const auto standings = race.standings();
  ASSERT_EQ(standings.size(), 3U);
  EXPECT_EQ(standings[0].candidate, 1U);
  EXPECT_DOUBLE_EQ(standings[0].mean_rank, 1.4);  // 4 times second of 10
  EXPECT_DOUBLE_EQ(standings[1].mean_rank, 1.6);
  EXPECT_DOUBLE_EQ(standings[2].mean_rank, 3);
  EXPECT_DOUBLE_EQ(standings[2].median, 4);
  EXPECT_LT(standings[1].behind.low, 0.2);
  EXPECT_GT(standings[1].behind.high, 0.2);
  EXPECT_GT(standings[2].behind.low, 0);
}

}  // namespace
}  // namespace lasius::study
