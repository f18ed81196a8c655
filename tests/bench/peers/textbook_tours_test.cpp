#include "bench/peers/textbook_tours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace lasius::peers {
namespace {

TEST(TextbookTours, VisitEachStopOnceAndTellTheirCost) {
  for (const int size : {8, 13, 60, 200}) {
    std::mt19937_64 random(3);
    std::vector<std::int32_t> costs(static_cast<std::size_t>(size) * size, 0);
    for (int a = 0; a < size; ++a)
      for (int b = 0; b < a; ++b)
        costs[a * size + b] = costs[b * size + a] = static_cast<std::int32_t>(random() % 1000);
    std::int64_t first = 0;
    for (const TourMethod method : {TourMethod::two_opt, TourMethod::ils, TourMethod::restarts}) {
      std::int64_t told = 0;
      int rounds = 0;
      const std::vector<int> tour = textbook_tour(
          size, costs, method, 1,
          [&](std::int64_t cost) {
            EXPECT_TRUE(told == 0 || cost < told);
            told = cost;
            return true;
          },
          [&] { return ++rounds > 300; });
      std::int64_t sum = 0;
      for (int p = 0; p < size; ++p) sum += costs[tour[p] * size + tour[(p + 1) % size]];
      EXPECT_EQ(told, sum);
      if (method == TourMethod::two_opt) first = told;
      if (method == TourMethod::ils) {
        EXPECT_LE(told, first);
      }
      std::vector<int> sorted = tour;
      std::sort(sorted.begin(), sorted.end());
      for (int v = 0; v < size; ++v) ASSERT_EQ(sorted[v], v);
    }
  }
}

}  // namespace
}  // namespace lasius::peers
