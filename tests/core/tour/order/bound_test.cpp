#include "core/tour/order/bound.h"

#include <gtest/gtest.h>

#include "core/tour/order/search.h"
#include "core/tour/order/subset_dp.h"
#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

// Knows some legs alone; of the others a bound that is half.
struct Half final : Pricer {
  explicit Half(const Instance& of) : stops(of) {}
  Cost price(int a, int b) override { return stops.costs()(a, b); }
  Cost lower(int a, int b) const override { return price_known(a, b) / ((a + b) % 3 == 0 ? 2 : 1); }
  Cost largest() const override { return stops.costs().largest(); }
  Cost price_known(int a, int b) const { return stops.costs()(a, b); }
  const Instance& stops;
};

TEST(TourBound, IsNeverAboveTheOptimumAndNear) {
  int cases = 0, near = 0;
  for (std::uint32_t seed = 1; seed <= 30; ++seed)
    for (const Ends& ends : kEnds) {
      const Instance stops = random_instance(3 + static_cast<int>(seed % 10), seed, seed % 2);
      const auto best = cost_of(stops.costs(), subset_order(stops.costs(), ends), ends.open);
      const StopCondition never;
      Poller poller(never), again(never);
      // With an upper bound above the optimum, so that nothing is cut down to it.
      const auto bound = tour_bound(stops.costs(), ends, stops.places, best + 5, 20, poller);
      EXPECT_LE(bound, best) << "seed " << seed;
      ++cases;
      near += 100 * bound >= 97 * best;
      Half half(stops);
      EXPECT_LE(tour_bound({stops.size, half}, ends, stops.places, best + 5, 20, again), best);
    }
  EXPECT_EQ(cases, 180);
  EXPECT_GE(near, 140);
}

// Legs that wind: up to nine times their bounds, until they are priced.
struct Winding final : Pricer {
  explicit Winding(const Instance& of) : stops(of), known(of.matrix.size(), 0) {}
  Cost price(int a, int b) override {
    known[a * stops.size + b] = known[b * stops.size + a] = 1;
    return stops.costs()(a, b);
  }
  Cost lower(int a, int b) const override {
    return stops.costs()(a, b) / (known[a * stops.size + b] != 0 ? 1 : factor(a, b));
  }
  Cost largest() const override { return stops.costs().largest(); }
  static int factor(int a, int b) { return 1 + (a + b) % 9; }
  const Instance& stops;
  std::vector<char> known;
};

TEST(TourBound, IsAsGreatWhereBoundsOfLegsArePoor) {
  const Instance stops = random_instance(300, 3);
  const auto cost =
      find_order(stops.costs(), {}, stops.places, {.kicks = 300, .generations = 5}).cost;
  const StopCondition never;
  Poller poller(never), again(never);
  Winding winding(stops);
  const auto bound = tour_bound({stops.size, winding}, {}, stops.places, cost, 1, poller);
  EXPECT_GE(100 * bound, 99 * tour_bound(stops.costs(), {}, stops.places, cost, 1, again));
}

}  // namespace
}  // namespace lasius::tour
