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

/// Coordinates are 0 to `last`.
std::vector<Cell> random_stops(int count, int last) {
  std::mt19937 random(4);
  std::vector<Cell> stops;
  for (int i = 0; i < count; ++i)
    stops.push_back({random_in(0, last, random), random_in(0, last, random)});
  return stops;
}

TEST(Tour, AnObserverIsToldEachBetterOrderAndEndsIt) {
  const Planner planner(Grid(300, 300));
  const std::vector<Cell> stops = random_stops(100, 299);
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

TEST(Tour, ABoundThatWasProvenIsKeptWhateverEndsTheRun) {
  const Planner planner(Grid(200, 200));
  const std::vector<Cell> stops = random_stops(60, 199);
  for (const bool two : {false, true}) {
    TourRequest request{.stops = stops, .generations = 0, .target_gap = 1e-9};
    if (two) request.robots = {0, 1};
    const CountingTime first(1 << 30), counted(1 << 30);
    request.stop = first.is_up();
    const TourResult at_first = plan_tour(planner, request);
    ASSERT_TRUE(at_first.lower_bound);
    request.generations = 3;
    request.stop = counted.is_up();
    plan_tour(planner, request);
    const int polls = first.polls(), more = counted.polls() - polls;
    ASSERT_GT(more, 20);
    for (int i = 0; i < 20; ++i) {
      const CountingTime time(polls + more * i / 20);
      request.stop = time.is_up();
      const TourResult cut = plan_tour(planner, request);
      EXPECT_GE(cut.lower_bound, at_first.lower_bound) << two << " " << i;
      EXPECT_LE(cut.length, at_first.length) << two << " " << i;
    }
  }
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
