// The hunt's judges find nothing in what is right; what it finds gets small, and comes here.
#include "bench/hunt/hunt.h"

#include <gtest/gtest.h>

#include "tests/worlds/grids.h"

namespace lasius::bench {
namespace {

TEST(Hunt, FindsNothing) {
  for (const HuntKind& kind : hunt_kinds()) {
    std::int64_t answers = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const HuntVerdict verdict = kind.judge(kind.make(seed));
      EXPECT_EQ(verdict.fault, "") << kind.name << ' ' << seed;
      answers += verdict.answers;
    }
    EXPECT_GT(answers, 0) << kind.name;
  }
}

TEST(Hunt, MakesTheSameProblemAgain) {
  const HuntCase one = hunt_kind("tour").make(5), other = hunt_kind("tour").make(5);
  EXPECT_EQ(one.grid.hash(), other.grid.hash());
  EXPECT_EQ(one.places, other.places);
  EXPECT_NE(one.seed, hunt_kind("tour").make(6).seed);
}

// "Wrong" where a blocked cell is right of the first place: one is left of it, and that.
TEST(Hunt, CutsDownWhatItFinds) {
  const auto faulty = [](const HuntCase& c) {
    return c.places.size() >= 2 && c.grid.free(c.places[0]) && c.places[0].x + 1 < c.grid.width() &&
           c.grid.blocked({c.places[0].x + 1, c.places[0].y});
  };
  HuntCase found{grid_of(12, 9, [](int x, int y) { return (x * 5 + y) % 3 == 1; }),
                 {{2, 1}, {8, 6}, {5, 4}, {11, 8}},
                 9};
  ASSERT_TRUE(faulty(found));
  const HuntCase small = reduced(found, faulty);
  EXPECT_TRUE(faulty(small));
  EXPECT_EQ(small.places.size(), 2u);
  EXPECT_EQ(small.grid.width() * small.grid.height() - small.grid.count_free(), 1);
  EXPECT_LE(small.grid.width(), 3);
  EXPECT_LE(small.grid.height(), 2);
  const std::string text = as_test(hunt_kind("tour"), small);
  EXPECT_NE(text.find("hunt_kind(\"tour\")"), std::string::npos);
  EXPECT_NE(text.find('@'), std::string::npos);
}

}  // namespace
}  // namespace lasius::bench
