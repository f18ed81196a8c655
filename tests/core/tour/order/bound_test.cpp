#include "core/tour/order/bound.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace lasius::tour
