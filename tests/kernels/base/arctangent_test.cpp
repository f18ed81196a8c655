#include "kernels/base/arctangent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lasius::kernels {
namespace {

TEST(Arctangent, IsExactOnTheAxesAndTheDiagonal) {
  EXPECT_EQ(quadrant_angle(1, 0), 0);
  EXPECT_EQ(quadrant_angle(0, 3), std::acos(0.0));
  EXPECT_EQ(quadrant_angle(2, 2), std::atan(1.0));
}

TEST(Arctangent, AgreesWithLibm) {
  double before = 0;
  for (int i = 1; i < 200000; ++i) {
    const double turn = 1.5707 * i / 200000;
    const double x = 0.7 * std::cos(turn), y = 0.7 * std::sin(turn);
    const long double expected =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    const double angle = quadrant_angle(x, y);
    ASSERT_LT(std::abs(angle - expected), 0x1.8p-52L * expected) << x << ' ' << y;
    ASSERT_GE(angle, before);
    before = angle;
  }
  for (double x = 1e-30; x < 1e30; x *= 1.37) {
    const long double expected = std::atan2(1.0L, static_cast<long double>(x));
    ASSERT_LT(std::abs(quadrant_angle(x, 1) - expected), 0x1.8p-52L * expected) << x;
  }
}

}  // namespace
}  // namespace lasius::kernels
