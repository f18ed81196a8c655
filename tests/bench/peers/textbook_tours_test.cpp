#include "bench/peers/textbook_tours.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/tour/order/instances.h"

namespace lasius::peers {
namespace {

TEST(TextbookTours, VisitEachStopOnceAndTellTheirCost) {
  for (const int size : {8, 13, 60, 200}) {
    const tour::Instance stops = tour::random_instance(size, 3);
    std::int64_t first = 0;
    for (const TourMethod method : {TourMethod::two_opt, TourMethod::ils, TourMethod::restarts}) {
      std::int64_t told = 0;
      int rounds = 0;
      const std::vector<int> tour = textbook_tour(
          size, stops.matrix, method, 1,
          [&](std::int64_t cost) {
            EXPECT_TRUE(told == 0 || cost < told);
            told = cost;
            return true;
          },
          [&] { return ++rounds > 300; });
      EXPECT_EQ(told, tour::cost_of(stops.costs(), tour, false));
      if (method == TourMethod::two_opt) first = told;
      EXPECT_LE(told, first);
      std::vector<int> sorted = tour;
      std::sort(sorted.begin(), sorted.end());
      for (int v = 0; v < size; ++v) ASSERT_EQ(sorted[v], v);
    }
  }
}

}  // namespace
}  // namespace lasius::peers
