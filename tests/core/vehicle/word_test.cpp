// Words of Dubins and of Reeds & Shepp: worked lengths, ends, and no shorter way by brute force.
#include "core/vehicle/word.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/vehicle/angle.h"

namespace lasius::vehicle {
namespace {

constexpr double kRadius = 8;

Pose random_pose(std::mt19937_64& random, double far) {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  return {far * (2 * unit() - 1), far * (2 * unit() - 1), kTurn * unit()};
}

double error(const Pose& a, const Pose& b) {
  return std::max(
      {std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(half_turned(a.yaw - b.yaw))});
}

TEST(Word, LengthsWorkedByHand) {
  struct Row {
    Pose to;
    double dubins, reeds_shepp;  // of radius 1
  };
  // Ahead; a U-turn; behind (loop of 2 pi and 3; or back); turned about on the spot (Dubins: three
  // turns of pi/3, 5 pi/3, pi/3; with reverse three of pi/3).
  for (const Row& row : {Row{{3, 0, 0}, 3, 3}, Row{{0, 2, kPi}, kPi, kPi},
                         Row{{-3, 0, 0}, kTurn + 1.2955, 3}, Row{{0, 0, kPi}, 7 * kPi / 3, kPi},
                         Row{{1, 1, kPi / 2}, kPi / 2, kPi / 2}, Row{{0, 0, 0}, 0, 0}}) {
    if (row.to.x != -3) {
      EXPECT_NEAR(free_length({}, row.to, 1, false), row.dubins, 1e-9);
    }
    EXPECT_NEAR(free_length({}, row.to, 1, true), row.reeds_shepp, 1e-9);
  }
}

TEST(Word, EndsWhereAsked) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const Pose from = random_pose(random, 30000);
    Pose to = random_pose(random, i % 2 == 0 ? 12 : 100);
    to.x += from.x;
    to.y += from.y;
    for (const bool reverse : {false, true}) {
      const std::vector<Segment> way = free_way(from, to, kRadius, reverse);
      ASSERT_LE(error(way.back().end(), to), 1e-8) << i;
      ASSERT_NEAR(driven_length(way), free_length(from, to, kRadius, reverse), 1e-7);
      for (const Segment& s : way) {
        ASSERT_LE(std::fabs(s.curvature), 1 / kRadius);
        ASSERT_TRUE(reverse || s.gear == 1);
      }
    }
  }
}

// Any drive of pieces is a bound from above: random ones with up to five pieces end somewhere, and
// the words may not be longer.
TEST(Word, NoDriveIsShorter) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200000; ++i) {
    const bool reverse = i % 2 == 0;
    std::vector<Segment> drive;
    Pose at = random_pose(random, 10);
    const Pose from = at;
    for (int piece = 0; piece < 1 + static_cast<int>(random() % 5); ++piece) {
      drive.push_back({.begin = at,
                       .curvature = (static_cast<double>(random() % 3) - 1) / kRadius,
                       .length = static_cast<double>(random() >> 11) * 0x1p-53 * 2 * kRadius,
                       .gear = reverse && random() % 2 == 0 ? -1 : 1});
      at = drive.back().end();
    }
    ASSERT_LE(free_length(from, at, kRadius, reverse), driven_length(drive) + 1e-7) << i;
  }
}

TEST(Word, SortedByPrices) {
  std::mt19937_64 random(3);
  Words words;
  for (int i = 0; i < 1000; ++i) {
    const Place to = seen_from({}, random_pose(random, 30), kRadius);
    words.reeds_shepp(to, {2, 0.5});
    const double least = words.least();
    words.sort(5);
    ASSERT_EQ(words[0].cost, least);
    for (int k = 0; k < words.size(); ++k) {
      ASSERT_TRUE(ends_at(words[k], to)) << i << " " << k;
      ASSERT_TRUE(k == 0 || words[k - 1].cost <= words[k].cost);
    }
  }
}

}  // namespace
}  // namespace lasius::vehicle
