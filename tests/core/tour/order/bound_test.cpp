#include "core/tour/order/bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

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

// Stops along the teeth of a comb, whose legs from tooth to tooth go by its back. Of those only the
// straight distance is known until they are priced.
struct Comb final : Pricer {
  static constexpr int kTeeth = 9, kDeep = 16, kApart = 4, kGrains = 1000;
  Comb() : known(kTeeth * kDeep * kTeeth * kDeep, 0) {}
  static int size() { return kTeeth * kDeep; }
  static Cost leg(int a, int b, bool straight) {
    const int across = kApart * std::abs(a / kDeep - b / kDeep);
    const int down_a = a % kDeep + 1, down_b = b % kDeep + 1;
    const int along = std::abs(down_a - down_b);
    return kGrains * (across == 0 ? along
                      : straight  ? std::max(across, along)
                                  : across + down_a + down_b);
  }
  Cost price(int a, int b) override {
    known[a * size() + b] = known[b * size() + a] = 1;
    return leg(a, b, false);
  }
  Cost lower(int a, int b) const override { return leg(a, b, known[a * size() + b] == 0); }
  Cost largest() const override { return leg(kDeep - 1, size() - 1, false); }
  std::vector<char> known;
};

TEST(TourBound, IsAsGreatWhereBoundsOfLegsArePoor) {
  // Down each tooth and up again, along the back and home.
  const std::int64_t best =
      2 * Comb::kGrains * (Comb::kTeeth * Comb::kDeep + Comb::kApart * (Comb::kTeeth - 1));
  const StopCondition never;
  Poller poller(never);
  Comb comb;
  const auto bound = tour_bound({Comb::size(), comb}, {}, {}, best, 4, poller);
  EXPECT_LE(bound, best);
  EXPECT_GE(100 * bound, 90 * best);
}

// Corridors that branch, whose tours pass each twice: short steps of the ascent are too few there.
TEST(TourBound, IsWithinAPerCentInCorridors) {
  constexpr int kSize = 80;
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    kernels::RandomStream random(seed, 0, 0);
    std::vector<Cost> matrix(std::size_t{kSize} * kSize, 0);
    std::int64_t best = 0;
    for (int v = 1; v < kSize; ++v) {
      const int from = std::max(0, v - 1 - random.below(6)), length = 1 + random.below(10'000);
      best += 2 * length;
      for (int w = 0; w < v; ++w)
        matrix[v * kSize + w] = matrix[w * kSize + v] = matrix[from * kSize + w] + length;
    }
    const StopCondition never;
    Poller poller(never);
    const auto bound = tour_bound({kSize, matrix.data()}, {}, {}, best, 10, poller);
    EXPECT_LE(bound, best);
    EXPECT_GE(100 * bound, 99 * best) << "seed " << seed;
  }
}

}  // namespace
}  // namespace lasius::tour
