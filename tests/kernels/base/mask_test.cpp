#include "kernels/base/mask.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/kernels/base/instruction_sets.h"

namespace lasius::kernels {
namespace {

class MeetsMask : public testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(Masks, MeetsMask, testing::ValuesIn(supported_isas()), by_isa);

TEST_P(MeetsMask, LooksAtEveryBitOfTheMaskAlone) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    const int rows = kMaskRows * static_cast<int>(random() % 6);
    const int shift = static_cast<int>(random() % 64);
    std::vector<std::uint64_t> left(rows), right(rows), mask(rows);
    // Few bits, so that both answers are usual.
    for (std::vector<std::uint64_t>* of : {&left, &right, &mask})
      for (std::uint64_t& word : *of) word = random() & random() & random();
    bool met = false;
    for (int row = 0; row < rows; ++row) {
      for (int bit = 0; bit < 64; ++bit) {
        const int at = shift + bit;
        const std::uint64_t word = at < 64 ? left[row] >> at : right[row] >> (at - 64);
        met = met || ((word & 1) != 0 && (mask[row] >> bit & 1) != 0);
      }
    }
    ASSERT_EQ(meets_mask(GetParam())(left.data(), right.data(), mask.data(), rows, shift), met);
  }
}

}  // namespace
}  // namespace lasius::kernels
