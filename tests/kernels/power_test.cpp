#include "kernels/power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lasius::kernels {
namespace {

TEST(Power, IsExactWhereTheResultIsAPowerOfTwo) {
  EXPECT_EQ(power(1, 4), 1);
  EXPECT_EQ(power(2, 3), 8);
  EXPECT_EQ(power(0.25, 0.5), 0.5);
  EXPECT_EQ(power(7, 0), 1);
}

TEST(Power, AgreesWithLibmToElevenDigits) {
  for (double x = 1e-30; x < 1e30; x *= 1.0731) {
    for (double a = -9; a <= 9; a += 0.31) {
      const double expected = std::pow(x, a);
      EXPECT_NEAR(power(x, a) / expected, 1, 1e-11) << x << "^" << a;
    }
  }
}

TEST(Power, GrowsWithItsBase) {
  double before = 0;
  for (double x = 0.5; x < 2.5; x += 1e-4) {
    const double now = power(x, 3.7);
    EXPECT_GT(now, before) << x;
    before = now;
  }
}

}  // namespace
}  // namespace lasius::kernels
