// What ends a tour: an observer, and time.
#include <gtest/gtest.h>

#include <random>
#include <span>
#include <vector>

#include "lasius/tour/tour.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

TEST(Tour, AnObserverIsToldEachBetterOrderAndEndsIt) {
  const Planner planner(Grid(300, 300));
  std::mt19937 random(4);
  std::vector<Cell> stops;
  for (int i = 0; i < 100; ++i)
    stops.push_back({random_in(0, 299, random), random_in(0, 299, random)});
  int of_several = 0;
  for (const double gap : {0.0, 1e-6}) {
    for (const bool two : {false, true}) {
      TourRequest request{.stops = stops, .generations = 2, .target_gap = gap};
      if (two) request.robots = {0, 1};
      std::vector<double> told;
      const TourResult whole = plan_tour(
          planner, request, [&](std::span<const int>, double length) { told.push_back(length); });
      ASSERT_FALSE(told.empty());
      of_several += told.size() > 1;
      for (std::size_t i = 1; i < told.size(); ++i) EXPECT_LT(told[i], told[i - 1]);
      int calls = 0;
      const TourResult cut =
          plan_tour(planner, request, [&](std::span<const int> order, double length) {
            EXPECT_EQ(order.size(), 100u);
            EXPECT_EQ(length, told[0]);
            ++calls;
            return Go::stop;
          });
      EXPECT_EQ(calls, 1);
      EXPECT_EQ(cut.status, Status::interrupted);
      EXPECT_EQ(cut.order.size(), 100u);
      EXPECT_EQ(cut.length > whole.length + 1e-6, told.size() > 1) << gap << " " << two;
    }
  }
  EXPECT_GE(of_several, 2);
}

TEST(Tour, IsStoppedAmongManyRegions) {
  Grid grid(80, 80);
  for (int i = 0; i < 80; ++i) grid.fill({0, i, 80, 1}, i % 2 == 1);
  for (int i = 1; i < 80; i += 2) grid.fill({i, 0, 1, 80}, true);
  TourRequest request;
  for (const Cell c : cells_of(grid))
    if (grid.free(c)) request.stops.push_back(c);
  ASSERT_EQ(request.stops.size(), 1600u);
  const Planner planner(grid);
  EXPECT_EQ(plan_tour(planner, request).order.size(), 1u);
  const CountingTime now(0);
  request.stop = now.is_up();
  const TourResult cut = plan_tour(planner, request);
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_TRUE(cut.order.empty());
}

}  // namespace
}  // namespace lasius
