#include "kernels/base/random_stream.h"

#include <gtest/gtest.h>

namespace lasius::kernels {
namespace {

TEST(RandomStream, KnownAnswer) {
  // Random123's known answer of philox4x32 with 10 rounds: counter and key 0.
  RandomStream random(0, 0, 0);
  EXPECT_EQ(random.next(), 0x6627e8d5U);
  EXPECT_EQ(random.next(), 0xe169c58dU);
  EXPECT_EQ(random.next(), 0xbc57ac4cU);
  EXPECT_EQ(random.next(), 0x9b00dbd8U);
  // And all bits set.
  const auto words = random_words(~std::uint64_t{0}, {~0U, ~0U, ~0U, ~0U});
  EXPECT_EQ(words, (std::array{0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU}));
}

TEST(RandomStream, WordsAreThoseOfTheirCounters) {
  constexpr std::uint64_t kSeed = 0x123456789abcdef0;
  RandomStream random(kSeed, 3, 11, 2);
  for (std::uint32_t block = 0; block < 5; ++block) {
    for (const std::uint32_t word : random_words(kSeed, {block, 3, 11, 2})) {
      EXPECT_EQ(random.next(), word) << block;
    }
  }
}

TEST(RandomStream, BelowAndChanceByHand) {
  EXPECT_EQ(below(10, 0), 0);
  EXPECT_EQ(below(10, 0x1999999a), 1);  // just above a tenth of all words
  EXPECT_EQ(below(10, 0x19999999), 0);
  EXPECT_EQ(below(10, 0xffffffff), 9);
  EXPECT_EQ(below(2147483647, 0xffffffff), 2147483646);
  // The first words are 0x6627e8d5, 0xe169c58d: 0.399 and 0.880 of all.
  RandomStream random(0, 0, 0);
  EXPECT_TRUE(random.chance(0.4));
  EXPECT_FALSE(random.chance(0.88));
  EXPECT_FALSE(random.chance(0));
  EXPECT_TRUE(random.chance(1));
}

}  // namespace
}  // namespace lasius::kernels
