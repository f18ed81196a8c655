#include "tools/draw/text.h"

#include <gtest/gtest.h>

#include <limits>

namespace lasius::tool {
namespace {

TEST(Fixed, RoundsAndKeepsSigns) {
  EXPECT_EQ(fixed(1.25, 1), "1.2");
  EXPECT_EQ(fixed(-1.5, 2), "-1.50");
  EXPECT_EQ(fixed(-0.005001, 2), "-0.01");
  EXPECT_EQ(fixed(10, 0), "10");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "-");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "-");
}

TEST(Fixed, ZeroHasNoSign) {
  EXPECT_EQ(fixed(-0.0, 2), "0.00");
  EXPECT_EQ(fixed(-0.004, 2), "0.00");
  EXPECT_EQ(fixed(-0.4, 0), "0");
  EXPECT_EQ(fixed(0, 3), "0.000");
}

}  // namespace
}  // namespace lasius::tool
