#include "kernels/race.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lasius::kernels {
namespace {

// All words: the lower 8 bits are not read. Where a word is larger, its time is not.
TEST(Race, TimesAreLogarithmsWithinTheErrorStated) {
  double worst = 0;  // share of that error
  float before = minus_log2(0);
  int rises = 0;
  for (std::uint32_t i = 0; i < 1 << 24; ++i) {
    const float time = minus_log2(i << 8);
    const double expected = 25 - std::log2(2.0 * i + 1);
    worst = std::max(worst, std::abs(time - expected) / (1e-6 * expected + 1e-7));
    rises += time > before;
    before = time;
  }
  EXPECT_LT(worst, 1);
  EXPECT_EQ(rises, 0);
  EXPECT_EQ(minus_log2(0x12345678), minus_log2(0x123456ff));
}

}  // namespace
}  // namespace lasius::kernels
