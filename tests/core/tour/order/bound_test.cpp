#include "core/tour/order/bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "core/tour/order/combs.h"
#include "core/tour/order/search.h"
#include "core/tour/order/subset_dp.h"
#include "kernels/base/random_stream.h"
#include "tests/core/base/counting_time.h"
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
      Poller poller(kNeverStops), again(kNeverStops);
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
struct Spine final : Pricer {
  static constexpr int kTeeth = 9, kDeep = 16, kApart = 4, kGrains = 1000;
  Spine() : known(kTeeth * kDeep * kTeeth * kDeep, 0) {}
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
      2 * Spine::kGrains * (Spine::kTeeth * Spine::kDeep + Spine::kApart * (Spine::kTeeth - 1));
  Poller poller(kNeverStops);
  Spine comb;
  const auto bound = tour_bound({Spine::size(), comb}, {}, {}, best, 4, poller);
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
    Poller poller(kNeverStops);
    const auto bound = tour_bound({kSize, matrix.data()}, {}, {}, best, 10, poller);
    EXPECT_LE(bound, best);
    EXPECT_GE(100 * bound, 99 * best) << "seed " << seed;
  }
}

// Of stops from `first` on: two triangles of halves, joined by three whole legs, a solution of Held
// & Karp's bound that is no tour. Either triangle is a handle with three teeth: 1.5 + 3 of its
// legs, where tours take 4.
void add_half_triangles(int first, std::vector<SharedLeg>& legs) {
  for (int i = first; i < first + 3; ++i) {
    const int next = first + (i - first + 1) % 3;
    legs.push_back({i, next, 0.5});
    legs.push_back({3 + i, 3 + next, 0.5});
    legs.push_back({i, 3 + i, 1});
  }
}

std::vector<Comb> all_combs_of(int stops, std::span<const SharedLeg> legs) {
  Poller poller(kNeverStops);
  return combs_of(stops, legs, poller);
}

TEST(Combs, AreFoundWhereTrianglesAreTakenHalf) {
  std::vector<SharedLeg> legs;
  add_half_triangles(0, legs);
  const std::vector<Comb> found = all_combs_of(6, legs);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].handle, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(found[0].teeth, (std::vector<std::vector<int>>{{0, 3}, {1, 4}, {2, 5}}));
  EXPECT_EQ(found[0].most(), 4);
}

TEST(Combs, AreNotLookedForOnceTimeIsUp) {
  constexpr int kPairs = 200, kLooks = 512;  // at what there is, between two at the clock
  std::vector<SharedLeg> legs;
  for (int pair = 0; pair < kPairs; ++pair) add_half_triangles(6 * pair, legs);
  const auto found_in = [&](const CountingTime& time) {
    const StopCondition stop = time.is_up();
    Poller poller(stop, kLooks);
    return std::ssize(combs_of(6 * kPairs, legs, poller));
  };
  const CountingTime endless(1 << 30), half(30), none(0);
  EXPECT_EQ(found_in(endless), 2 * kPairs);
  EXPECT_GT(endless.polls(), 100);
  const auto in_time = found_in(half);
  EXPECT_GT(in_time, 0);
  EXPECT_LT(in_time, 2 * kPairs);
  EXPECT_EQ(found_in(none), 0);
}

// One of the triangles, and in place of stop 3 a set of three, of which all but a leg is taken.
std::vector<SharedLeg> legs_of_a_wide_tooth() {
  std::vector<SharedLeg> legs{{3, 6, 1}, {3, 7, 0.5}, {6, 7, 0.5}, {6, 4, 0.5}, {7, 4, 0.5}};
  for (int i = 0; i < 3; ++i) {
    legs.push_back({i, (i + 1) % 3, 0.5});
    legs.push_back({i, 3 + i, 1});
  }
  return legs;
}

TEST(Combs, HaveTeethOfManyStops) {
  const Comb comb{{0, 1, 2}, {{0, 3, 6, 7}, {1, 4}, {2, 5}}};
  const std::vector<Comb> found = all_combs_of(8, legs_of_a_wide_tooth());
  EXPECT_NE(std::find(found.begin(), found.end(), comb), found.end());
  EXPECT_EQ(comb.most(), 3 + 3 + 1 + 1 - 2);
}

TEST(Combs, AreKeptByEveryTour) {
  constexpr int kStops = 8;
  kernels::RandomStream random(1, 0, 0, 1);
  int found = 0, wide = 0;
  for (int draw = 0; draw < 100; ++draw) {
    std::vector<SharedLeg> legs;
    for (int a = 0; a < kStops; ++a)
      for (int b = a + 1; b < kStops; ++b)
        if (random.below(2) == 0) legs.push_back({a, b, 0.25 * random.below(5)});
    if (draw % 2 != 0) {
      legs = legs_of_a_wide_tooth();
      for (SharedLeg& leg : legs)
        if (random.below(4) == 0) leg.share = 0.25 * random.below(5);
    }
    for (const Comb& comb : all_combs_of(kStops, legs)) {
      ++found;
      std::vector<std::vector<int>> sets = comb.teeth;
      sets.push_back(comb.handle);
      wide += std::any_of(sets.begin(), sets.end() - 1, [](const auto& s) { return s.size() > 2; });
      std::vector<int> tour(kStops);
      std::iota(tour.begin(), tour.end(), 0);
      std::vector<unsigned> masks;
      for (const auto& set : sets) {
        unsigned mask = 0;
        for (const int v : set) mask |= 1U << v;
        masks.push_back(mask);
      }
      do {
        std::int64_t taken = 0;
        for (int i = 0; i < kStops; ++i) {
          const unsigned leg = 1U << tour[i] | 1U << tour[(i + 1) % kStops];
          for (const unsigned mask : masks) taken += (mask & leg) == leg;
        }
        ASSERT_LE(taken, comb.most());
      } while (std::next_permutation(tour.begin() + 1, tour.end()));
    }
  }
  EXPECT_GT(found, 10);
  EXPECT_GT(wide, 0);
}

// Whether the bound is within a share of a tour that a search of so many generations finds.
void expect_bound_near(const Instance& stops, int generations, double share) {
  OrderOptions options;
  options.generations = generations;
  const auto best = find_order(stops.costs(), {}, stops.places, options).cost;
  Poller poller(kNeverStops);
  const auto bound = tour_bound(stops.costs(), {}, stops.places, best, 40, poller);
  EXPECT_LE(bound, best);
  EXPECT_GE(static_cast<double>(bound), (1 - share) * static_cast<double>(best));
}

// What the bound of trees alone leaves of stops in the plane is mostly what combs close.
TEST(TourBound, IsWithinHalfAPerCentInThePlane) {
  expect_bound_near(random_instance(150, 3, false), 40, 0.005);
}

// As swaths have it: what each leg costs more is no part of what a gap is worth.
TEST(TourBound, IsTheSameWhereAllLegsCostMoreAlike) {
  constexpr int kSize = 100;
  constexpr Cost kMore = kLargest / 2, kGrains = 1000;
  Instance stops = random_instance(kSize, 4, false);
  for (Cost& cost : stops.matrix) cost *= kGrains;
  std::vector<Cost> dearer = stops.matrix;
  for (int a = 0; a < kSize; ++a)
    for (int b = 0; b < kSize; ++b)
      if (a != b) dearer[a * kSize + b] += kMore;
  constexpr std::int64_t kAlike = std::int64_t{kSize} * kMore;
  const auto best = find_order(stops.costs(), {}, stops.places, {.generations = 5}).cost;
  Poller poller(kNeverStops);
  const auto dearer_bound = [&](std::int64_t alike) {
    return tour_bound({kSize, dearer.data()}, {}, stops.places, best + kAlike, 10, poller, alike) -
           kAlike;
  };
  const auto bound = tour_bound(stops.costs(), {}, stops.places, best, 10, poller);
  EXPECT_EQ(dearer_bound(kAlike), bound);
  EXPECT_LT(dearer_bound(0), bound);
}

// Prices of whole clusters are what is to be found there, and climbs are slow to.
TEST(TourBound, IsWithinTwoPerCentAmongClustersFarApart) {
  constexpr int kSize = 40, kClusters = 4, kApart = 20000;
  Instance stops = random_instance(kSize, 5, false);
  for (int v = 0; v < kSize; ++v) {
    stops.places[v].x += kApart * (v % kClusters / 2);
    stops.places[v].y += kApart * (v % 2);
  }
  for (int a = 0; a < kSize; ++a)
    for (int b = 0; b < kSize; ++b)
      stops.matrix[a * kSize + b] =
          static_cast<Cost>(std::abs(stops.places[a].x - stops.places[b].x) +
                            std::abs(stops.places[a].y - stops.places[b].y));
  expect_bound_near(stops, 20, 0.02);
}

}  // namespace
}  // namespace lasius::tour
