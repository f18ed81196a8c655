#include "kernels/walk/race.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lasius::kernels {
namespace {

// All words: the lower 8 bits are not read, the ninth counts as set.
TEST(Race, TimesAreLogarithmsWithinTheErrorStated) {
  double worst = 0;
  float least = 1;
  for (std::uint32_t i = 0; i < 1 << 23; ++i) {
    const float time = minus_log2(i << 9);
    worst = std::max(worst, std::abs(time - (24 - std::log2(2.0 * i + 1))));
    least = std::min(least, time);
  }
  EXPECT_LT(worst, 5e-6);
  EXPECT_GT(least, 0);
  EXPECT_EQ(minus_log2(0x12345678), minus_log2(0x123457ff));
}

}  // namespace
}  // namespace lasius::kernels
