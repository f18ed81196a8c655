#include "kernels/base/raise.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/base/power.h"
#include "tests/kernels/base/instruction_sets.h"

namespace lasius::kernels {
namespace {

class RaiseRow : public testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(Raise, RaiseRow, testing::ValuesIn(supported_isas()), by_isa);

/// `count` values from 2^-120 to 1, the range of shares, and one more.
std::vector<double> shares(int count) {
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) values.push_back(power(2, -120.0 * i / (count + 1)));
  return values;
}

TEST_P(RaiseRow, IsThePowerOfEachValueBitForBit) {
  for (const double exponent : {0.9, 1.8, -1.5, 0.0, 3.0, 64.0}) {
    for (int count = 0; count <= 40; ++count) {
      const auto before = shares(count);
      auto values = before;
      raise_row(GetParam())(values.data(), count, exponent);
      for (int i = 0; i < count; ++i) {
        EXPECT_EQ(values[i], power(before[i], exponent)) << count << " " << before[i];
      }
      EXPECT_EQ(values[count], before[count]);
    }
  }
}

TEST_P(RaiseRow, MultipliesForTheExponentsThatSchedulesEndAt) {
  for (int count = 0; count <= 40; ++count) {
    const auto before = shares(count);
    auto first = before, second = before, fourth = before;
    raise_row(GetParam())(first.data(), count, 1);
    raise_row(GetParam())(second.data(), count, 2);
    raise_row(GetParam())(fourth.data(), count, 4);
    EXPECT_EQ(first, before);
    for (int i = 0; i < count; ++i) {
      const double square = before[i] * before[i];
      EXPECT_EQ(second[i], square);
      EXPECT_EQ(fourth[i], square * square);
    }
    EXPECT_EQ(second[count], before[count]);
    EXPECT_EQ(fourth[count], before[count]);
  }
}

}  // namespace
}  // namespace lasius::kernels
