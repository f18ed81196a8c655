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

TEST(Arctangent, DirectionsOfAllQuadrantsAgreeWithLibm) {
  EXPECT_EQ(direction(0, 0), 0);
  EXPECT_EQ(direction(0, -2), std::acos(-1.0));
  EXPECT_EQ(direction(-2, 0), std::asin(-1.0));
  for (int i = -999; i <= 999; ++i) {
    const double turn = 3.1415 * i / 999, sine = i / 999.0;
    EXPECT_NEAR(direction(std::sin(turn), std::cos(turn)), turn, 1e-15) << i;
    EXPECT_NEAR(arc_cosine(sine), std::acos(sine), 1e-15) << i;
    EXPECT_NEAR(arc_sine(sine), std::asin(sine), 1e-15) << i;
  }
}

}  // namespace
}  // namespace lasius::kernels
