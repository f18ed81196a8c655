#include "tools/study/description/sweep.h"

#include <gtest/gtest.h>

#include <set>

namespace lasius::study {
namespace {

Factor range(const char* name, double from, double to, int levels = 0) {
  return {.name = name, .from = from, .to = to, .levels = levels};
}

TEST(Sweep, AGridIsEveryCombinationTheLastFactorFastest) {
  const std::vector<Factor> factors{{.name = "a", .values = {"1", "2"}}, range("b", 0, 1, 3)};
  EXPECT_EQ(grid_size(factors), 6);
  const std::vector<Settings> points{{{"a", "1"}, {"b", "0"}},   {{"a", "1"}, {"b", "0.5"}},
                                     {{"a", "1"}, {"b", "1"}},   {{"a", "2"}, {"b", "0"}},
                                     {{"a", "2"}, {"b", "0.5"}}, {{"a", "2"}, {"b", "1"}}};
  EXPECT_EQ(design_points(Design::grid, factors, 0, 0), points);
}

TEST(Sweep, ALatinHypercubeHasOnePointInEachPartOfEveryFactor) {
  constexpr int kPoints = 7;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = unit_points(Design::latin, kPoints, 4, seed);
    ASSERT_EQ(points.size(), std::size_t{kPoints});
    for (std::size_t d = 0; d < 4; ++d) {
      std::set<int> parts;
      for (const auto& point : points) {
        ASSERT_GE(point[d], 0);
        ASSERT_LT(point[d], 1);
        parts.insert(static_cast<int>(point[d] * kPoints));
      }
      EXPECT_EQ(parts.size(), std::size_t{kPoints}) << "seed " << seed << " factor " << d;
    }
  }
  // Factors are shuffled by themselves, and seeds are other points.
  const auto points = unit_points(Design::latin, 50, 2, 1);
  int same = 0;
  for (const auto& point : points)
    same += static_cast<int>(50 * point[0]) == static_cast<int>(50 * point[1]);
  EXPECT_LT(same, 10);
  EXPECT_EQ(points, unit_points(Design::latin, 50, 2, 1));
  EXPECT_NE(points, unit_points(Design::latin, 50, 2, 2));
  EXPECT_NE(points, unit_points(Design::random, 50, 2, 1));
}

TEST(Sweep, FirstFactorsStayWhereOthersAreAdded) {
  const auto two = unit_points(Design::latin, 9, 2, 3), three = unit_points(Design::latin, 9, 3, 3);
  for (std::size_t i = 0; i < two.size(); ++i) EXPECT_EQ(two[i][1], three[i][1]);
}

TEST(Sweep, AShareOfARangeIsAValue) {
  EXPECT_EQ(value_at(range("a", 2, 4), 0.25), "2.5");
  EXPECT_EQ(value_at(range("a", 0, 1), 0.123456), "0.1235");
  EXPECT_EQ(value_at(range("a", 0.99996, 0.99999), 0.5), "0.99999");  // rounded, and kept within
  Factor f = range("a", 1, 100);
  f.logarithmic = true;
  EXPECT_EQ(value_at(f, 0.5), "10");
  f.whole = true;
  EXPECT_EQ(value_at(f, 0.25), "3");  // 3.16
  EXPECT_EQ(value_at(f, 0), "1");
  f.from = 90000;
  f.to = 123456;
  EXPECT_EQ(value_at(f, 1), "123456");
}

TEST(Sweep, AShareOfAListIsOneOfItsValues) {
  const Factor f{.name = "a", .values = {"x", "y", "z"}};
  EXPECT_EQ(value_at(f, 0), "x");
  EXPECT_EQ(value_at(f, 0.34), "y");
  EXPECT_EQ(value_at(f, 0.999), "z");
  // Balanced in a hypercube, and a point that is there already is left out.
  const auto points = design_points(Design::latin, {f}, 6, 1);
  EXPECT_EQ(points.size(), 3U);
}

}  // namespace
}  // namespace lasius::study
