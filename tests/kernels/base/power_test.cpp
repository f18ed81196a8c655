#include "kernels/base/power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lasius::kernels {
namespace {

TEST(Power, IsExactWhereTheResultIsAPowerOfTwo) {
  EXPECT_EQ(power(1, 4), 1);
  EXPECT_EQ(power(2, 3), 8);
  EXPECT_EQ(power(0.25, 0.5), 0.5);
  EXPECT_EQ(power(7, 0), 1);
}

double relative_error(double x, double a) {
  const long double expected = std::pow(static_cast<long double>(x), static_cast<long double>(a));
  return static_cast<double>(std::abs(power(x, a) / expected - 1));
}

TEST(Power, AgreesWithLibmToTwelveDigits) {
  for (double x = 1e-30; x < 1e30; x *= 1.0731) {
    for (double a = -9; a <= 9; a += 0.31) EXPECT_LT(relative_error(x, a), 1e-12) << x << "^" << a;
  }
}

// The error is largest where the mantissa is, next to the square roots of 2 and 1/2, and grows with
// the exponent.
TEST(Power, KeepsItsErrorNextToTheSquareRootOfTwo) {
  for (const double root : {std::sqrt(2.0), std::sqrt(0.5)}) {
    for (const int e : {0, -1, 3, 14}) {
      for (double off = -1e-3; off <= 1e-3; off += 1.7e-5) {
        const double x = std::ldexp(root * (1 + off), e);
        const double most = 999.9 / std::abs(std::log2(x));
        for (const double share : {1.0, -1.0, 0.7, -0.1}) {
          EXPECT_LT(relative_error(x, share * std::min(most, 64.0)), 1e-12) << x;
          EXPECT_LT(relative_error(x, share * most), 3e-11) << x << "^" << share * most;
        }
      }
    }
  }
}

TEST(Power, StaysAtItsEndsBeyondThem) {
  const double least = std::ldexp(1.0, -1000), most = std::ldexp(1.0, 1000);
  for (const double a : {5.0, 5.119, 5.12, 15.4, 16.0, 20.0, 64.0}) {
    EXPECT_EQ(power(0x1p-200, a), least) << a;
    EXPECT_EQ(power(0x1p-200, -a), most) << a;
    EXPECT_EQ(power(0x1p200, a), most) << a;
    EXPECT_EQ(power(0x1p200, -a), least) << a;
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
