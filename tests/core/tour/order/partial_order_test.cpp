#include "core/tour/order/partial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/tour/order/path_exchange.h"
#include "core/tour/order/search.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/order/window_search.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/order/given.h"
#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

TEST(PartialOrder, NamesACircle) {
  EXPECT_TRUE(circle_of(4, std::vector<Before>{{0, 1}, {1, 2}, {0, 2}, {3, 2}}).empty());
  EXPECT_EQ(circle_of(6, std::vector<Before>{{5, 0}, {4, 2}, {2, 1}, {1, 4}, {1, 3}, {3, 5}}),
            (std::vector<int>{1, 4, 2}));
  EXPECT_EQ(circle_of(2, std::vector<Before>{{1, 1}}), (std::vector<int>{1}));
}

TEST(PartialOrder, IsReducedToWhatFollowsAtOnce) {
  const PartialOrder given(70, std::vector<Before>{{0, 69}, {69, 3}, {0, 3}, {0, 69}, {5, 3}});
  EXPECT_TRUE(given.before(0, 3));
  EXPECT_FALSE(given.before(3, 0));
  ASSERT_EQ(given.next(0).size(), 1u);
  EXPECT_EQ(given.next(0).front(), 69);
  EXPECT_EQ(given.previous(3).size(), 2u);
  EXPECT_TRUE(given.parted(0, 3));
  EXPECT_TRUE(given.parted(69, 0));
  EXPECT_FALSE(given.parted(0, 69));
  EXPECT_FALSE(given.parted(0, 5));
}

// Against all orders; every kind of ends, with and without a capacity; also the search for many
// stops, of as few.
TEST(PartialOrder, GivesTheBestOfAllOrdersThatKeepIt) {
  int none = 0, cases = 0, equal = 0;
  for (std::uint32_t seed = 1; seed <= 12; ++seed)
    for (int size = 2; size <= 8; ++size)
      for (const Ends& ends : kEnds) {
        if (std::max(ends.start, ends.goal) >= size) continue;
        const Instance stops = random_instance(size, seed, seed % 2);
        const Given given = random_given(size, seed, ends);
        const double best = least_cost(stops.costs(), ends, given);
        const PartialOrder partial = given.order(size);
        OrderOptions options;
        options.given = &partial;
        options.generations = 1;
        const OrderFound exact = find_order(stops.costs(), ends, stops.places, options),
                         found = find_partial_order(stops.costs(), ends, partial, options);
        ++cases;
        ASSERT_EQ(exact.order.empty(), std::isinf(best)) << size << " stops, seed " << seed;
        ASSERT_EQ(found.order.empty(), exact.order.empty()) << size << " stops, seed " << seed;
        EXPECT_TRUE(exact.optimal);
        if (exact.order.empty()) {
          EXPECT_TRUE(found.optimal);
          ++none;
          continue;
        }
        EXPECT_TRUE(kept(exact.order, given, ends));
        EXPECT_EQ(exact.cost, best) << size << " stops, seed " << seed;
        EXPECT_EQ(exact.cost, cost_of(stops.costs(), exact.order, ends.open));
        EXPECT_TRUE(kept(found.order, given, ends)) << size << " stops, seed " << seed;
        EXPECT_EQ(found.cost, cost_of(stops.costs(), found.order, ends.open));
        equal += static_cast<double>(found.cost) == best;
      }
  EXPECT_GT(none, 5);
  EXPECT_EQ(equal, cases - none);
}

TEST(PartialOrder, IsKeptByEveryOrderThatIsTold) {
  int cases = 0;
  for (std::uint32_t seed = 1; cases < 2000; ++seed)
    for (const Ends& ends : kEnds) {
      const int size = 13 + static_cast<int>(seed % 40);
      const Instance stops = random_instance(size, seed, seed % 3 == 0);
      const Given given = random_given(size, seed, ends);
      const PartialOrder partial = given.order(size);
      OrderOptions options;
      options.given = &partial;
      options.seed = seed;
      options.generations = seed % 10 == 0;
      options.observer = [&](std::span<const int> order, std::int64_t) {
        EXPECT_TRUE(kept({order.begin(), order.end()}, given, ends)) << "seed " << seed;
        return true;
      };
      const OrderFound found = find_order(stops.costs(), ends, stops.places, options);
      if (found.order.empty()) continue;  // of a capacity
      std::vector<int> sorted = found.order;
      std::sort(sorted.begin(), sorted.end());
      for (int v = 0; v < size; ++v) ASSERT_EQ(sorted[v], v);
      ASSERT_TRUE(kept(found.order, given, ends)) << "seed " << seed;
      ASSERT_EQ(found.cost, cost_of(stops.costs(), found.order, ends.open));
      ++cases;
    }
}

TEST(PartialOrder, OfAsymmetricCostsIsThatOfSubsets) {
  int equal = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const int size = 13;
    Instance stops = random_instance(size, seed);
    kernels::RandomStream random(seed, 2, 0);
    for (Cost& cost : stops.matrix) cost += random.below(60);
    const Ends ends{true, 0, size - 1};
    const PartialOrder partial = random_given(size, seed, ends).order(size);
    OrderOptions options;
    options.given = &partial;
    options.generations = 2;
    const OrderFound found = find_order(stops.costs(), ends, {}, options);
    const auto best = subset_order(stops.costs(), ends, partial);
    ASSERT_EQ(found.order.empty(), best.empty());
    equal += best.empty() || found.cost == cost_of(stops.costs(), best, true);
  }
  EXPECT_GE(equal, 19);
}

// Also where that stop must come before what follows the piece.
TEST(PathExchange, PutsAPieceBeforeAStop) {
  const std::vector<Cost> matrix = {0,  5,  10, 99, 99,  //
                                    99, 0,  10, 0,  99,  //
                                    99, 5,  0,  5,  99,  //
                                    99, 99, 99, 0,  0,   //
                                    99, 99, 99, 99, 0};
  const Costs costs(5, matrix.data());
  const PartialOrder given(5, std::vector<Before>{{1, 3}});
  Poller poller(kNeverStops);
  const StopPath path(costs, {true, 0, 4}, given, poller);
  PathExchange exchange(path);
  exchange.set({0, 1, 2, 3, 4});
  exchange.wake_all();
  EXPECT_TRUE(exchange.improve(poller));
  EXPECT_EQ(exchange.now().nodes, (std::vector<int>{0, 2, 1, 3, 4}));
}

TEST(PartialOrder, TheFirstOrderGoesToTheNearestStop) {
  const std::vector<Cost> matrix = {0, 9, 1, 9, 0, 9, 1, 9, 0};
  const PartialOrder given(3, std::vector<Before>{});
  EXPECT_EQ(first_order(Costs(3, matrix.data()), {true, 0}, given).order,
            (std::vector<int>{0, 2, 1}));
}

TEST(PartialOrder, StoppedGivesTheBestSoFar) {
  const Instance stops = random_instance(120, 7);
  const Given given = random_given(120, 7, {});
  const PartialOrder partial = given.order(120);
  OrderOptions options;
  options.given = &partial;
  options.stop = fired();
  const OrderFound found = find_order(stops.costs(), {}, stops.places, options);
  EXPECT_TRUE(kept(found.order, given, {}));
  EXPECT_EQ(found.cause, StopCondition::Cause::token);
}

}  // namespace
}  // namespace lasius::tour
