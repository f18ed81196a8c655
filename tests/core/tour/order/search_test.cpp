#include "core/tour/order/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/tour/order/subset_dp.h"
#include "lasius/base/error.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/order/given.h"
#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

void expect_order(const OrderFound& found, const Costs& costs, const Ends& ends) {
  std::vector<int> sorted = found.order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(costs.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  EXPECT_TRUE(kept(found.order, {}, ends));
  EXPECT_EQ(found.cost, cost_of(costs, found.order, ends.open));
}

TEST(TourOrder, IsTheBestOfAllOrdersOfFewStops) {
  int cases = 0;
  for (std::uint32_t seed = 1; seed <= 12; ++seed)
    for (int size = 3; size <= 8; ++size)
      for (const Ends& ends : kEnds) {
        const Instance stops = random_instance(size, seed, seed % 2);
        const OrderFound found = find_order(stops.costs(), ends, stops.places, {});
        expect_order(found, stops.costs(), ends);
        EXPECT_EQ(found.cost, least_cost(stops.costs(), ends)) << size << " stops, seed " << seed;
        EXPECT_TRUE(found.optimal);
        ++cases;
      }
  EXPECT_EQ(cases, 12 * 6 * 6);
}

TEST(TourOrder, FindsTheBestOfThirteenAndMoreStopsByGenerations) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed)
    for (const Ends& ends : kEnds) {
      const Instance stops = random_instance(13 + static_cast<int>(seed % 2), seed, seed % 3 == 0);
      OrderOptions options;
      options.generations = 20;
      const OrderFound found = find_order(stops.costs(), ends, stops.places, options);
      expect_order(found, stops.costs(), ends);
      EXPECT_EQ(found.cost, cost_of(stops.costs(), subset_order(stops.costs(), ends), ends.open))
          << "seed " << seed;
    }
}

TEST(TourOrder, OneAndTwoStopsAreOrders) {
  for (const int size : {1, 2}) {
    const Instance stops = random_instance(size, 1);
    for (const bool open : {false, true})
      expect_order(find_order(stops.costs(), {open}, {}, {}), stops.costs(), {open});
  }
}

TEST(TourOrder, IsTheSameForTheSameSeedAndOnlyGetsCheaper) {
  const Instance stops = random_instance(120, 5);
  OrderOptions options;
  options.generations = 3;
  std::vector<std::int64_t> told;
  options.observer = [&](std::span<const int>, std::int64_t cost) {
    told.push_back(cost);
    return true;
  };
  const OrderFound one = find_order(stops.costs(), {}, stops.places, options);
  EXPECT_EQ(one.order, find_order(stops.costs(), {}, stops.places, options).order);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::adjacent_find(told.begin(), told.end(), [](auto a, auto b) { return b == a; }) ==
              told.end());
  EXPECT_EQ(told.back(), one.cost);
}

TEST(TourOrder, StoppedGivesTheBestSoFar) {
  const Instance stops = random_instance(200, 7);
  OrderOptions options;
  options.stop = fired();
  const OrderFound found = find_order(stops.costs(), {true, 3, 5}, stops.places, options);
  expect_order(found, stops.costs(), {true, 3, 5});
  EXPECT_EQ(found.cause, StopCondition::Cause::token);
}

TEST(TourOrder, RefusesEndsThatAreNone) {
  const Instance stops = random_instance(4, 1);
  for (const Ends& ends : {Ends{true, 4}, Ends{true, 1, 1}, Ends{false, -1, 2}, Ends{true, -2}})
    EXPECT_THROW(find_order(stops.costs(), ends, {}, {}), Error);
}

TEST(TourOrder, EndsAtItsTargetOrWhenTheObserverSaysSo) {
  const Instance stops = random_instance(300, 1, false);
  std::vector<std::int64_t> told;
  std::size_t most = 1000;
  OrderOptions options;
  options.generations = 2;
  options.observer = [&](std::span<const int>, std::int64_t cost) {
    told.push_back(cost);
    return told.size() < most;
  };
  (void)find_order(stops.costs(), kEnds[0], stops.places, options);
  const std::vector<std::int64_t> costs = told;
  ASSERT_GT(costs.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const bool by_target : {false, true}) {
      told.clear();
      options.target = by_target ? costs[i] : 0;
      most = by_target ? 1000 : i + 1;
      (void)find_order(stops.costs(), kEnds[0], stops.places, options);
      EXPECT_EQ(told, std::vector<std::int64_t>(costs.begin(), costs.begin() + std::ssize(told)));
      EXPECT_EQ(told.size(), i + 1) << by_target;
    }
  }
}

}  // namespace
}  // namespace lasius::tour
