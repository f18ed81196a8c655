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

TEST(Drawn, LongWordsAndTextsAreCutBetweenLetters) {
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string u = "\u00fc", more = "\u2026";
  const std::pair<std::string, std::string> cases[] = {
      {"", ""},
      {" a  b ", " a  b "},
      {times(100, u), times(100, u)},
      {times(101, u), times(99, u) + more},
      {"a " + times(9999, u) + " b", "a " + times(99, u) + more + " b"},
      {times(500, "a "), times(500, "a ")},
      {times(501, "a "), times(499, "a ") + "a" + more},
      {"a\x80", "a\ufffd"},
      {times(300, "\x80"), times(99, "\ufffd") + more},
  };
  for (const auto& [text, shown] : cases) {
    EXPECT_EQ(drawn(text), shown) << text;
    EXPECT_EQ(drawn(shown), shown) << text;
  }
}

}  // namespace
}  // namespace lasius::tool
