#include "tools/report/key_frames.h"

#include <gtest/gtest.h>

namespace lasius::tool {
namespace {

/// The frames that a run of so many ticks leaves.
KeyFrames<int> after(int ticks, std::size_t most) {
  KeyFrames<int> frames(most);
  for (int tick = 0; tick < ticks; ++tick)
    if (frames.wants(tick)) frames.add(tick);
  return frames;
}

TEST(KeyFrames, AShortRunKeepsEveryTick) {
  const auto frames = after(5, 5);
  EXPECT_EQ(frames.all(), (std::vector{0, 1, 2, 3, 4}));
  EXPECT_EQ(frames.stride(), 1);
}

TEST(KeyFrames, ALongerOneKeepsEverySecondThenEveryFourth) {
  EXPECT_EQ(after(6, 5).all(), (std::vector{0, 2, 4}));
  EXPECT_EQ(after(9, 5).all(), (std::vector{0, 2, 4, 6, 8}));
  EXPECT_EQ(after(14, 5).all(), (std::vector{0, 4, 8, 12}));
  EXPECT_EQ(after(14, 5).stride(), 4);
}

TEST(KeyFrames, NeverMoreThanAskedForAndHalfOfThemAtLeast) {
  for (const std::size_t most : {2U, 3U, 8U, 300U}) {
    for (int ticks = 1; ticks < 2000; ticks += 7) {
      const auto frames = after(ticks, most);
      ASSERT_LE(frames.all().size(), most) << ticks;
      ASSERT_GE(frames.all().size(), std::min<std::size_t>(ticks, most / 2)) << ticks;
      for (std::size_t i = 0; i < frames.all().size(); ++i)
        ASSERT_EQ(frames.all()[i], static_cast<int>(i) * frames.stride());
    }
  }
}

TEST(KeyFrames, ThinningKeepsTheFirst) {
  auto frames = after(3, 8);
  frames.thin();
  EXPECT_EQ(frames.all(), (std::vector{0, 2}));
  frames.thin();
  EXPECT_EQ(frames.all(), (std::vector{0}));
  KeyFrames<int> none(4);
  none.thin();
  EXPECT_TRUE(none.all().empty());
}

}  // namespace
}  // namespace lasius::tool
