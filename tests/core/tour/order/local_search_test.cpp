#include "core/tour/order/local_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "core/tour/order/recombine.h"
#include "core/tour/order/search.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

constexpr int kStops = 14;

// Is any tour cheaper that has all edges but two or three: the pieces between three cuts in any
// order and direction?
bool cheaper_by_three_edges(const Costs& costs, const std::vector<int>& order) {
  const std::int64_t now = cost_of(costs, order, false);
  const auto n = static_cast<std::ptrdiff_t>(order.size());
  for (std::ptrdiff_t i = 1; i < n; ++i)
    for (std::ptrdiff_t j = i + 1; j <= n; ++j)
      for (int way = 0; way < 8; ++way) {
        std::vector<int> b(order.begin() + i, order.begin() + j), c(order.begin() + j, order.end());
        if ((way & 1) != 0) std::reverse(b.begin(), b.end());
        if ((way & 2) != 0) std::reverse(c.begin(), c.end());
        if ((way & 4) != 0) std::swap(b, c);
        std::vector<int> other(order.begin(), order.begin() + i);
        other.insert(other.end(), b.begin(), b.end());
        other.insert(other.end(), c.begin(), c.end());
        if (cost_of(costs, other, false) < now) return true;
      }
  return false;
}

TEST(TourLocalSearch, LeavesNoCheaperExchangeOfThreeEdges) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    const Instance stops = random_instance(kStops, seed, seed % 2 == 0);
    const Costs costs = stops.costs();
    const Candidates candidates(costs, {}, kStops - 1);
    Poller poller(kNeverStops);
    kernels::RandomStream random(seed, 0, 0);
    ArrayTour tour(costs, random_order(costs, candidates, random));
    LocalSearch search(costs, candidates);
    // Again: what a change makes cheaper may begin at a stop that it did not touch.
    for (std::int64_t before = -1; before != tour.cost();) {
      before = tour.cost();
      EXPECT_TRUE(search.improve(tour, poller));
    }
    EXPECT_EQ(tour.cost(), cost_of(costs, tour.order(), false));
    const std::vector<int> order = tour.order();
    tour.undo();
    EXPECT_EQ(tour.order(), order);  // kept
    EXPECT_FALSE(cheaper_by_three_edges(costs, tour.order())) << "seed " << seed;
  }
}

// From the middle, four stops lie to the lower right, one far to the left and one, the last, less
// far there.
TEST(TourCandidates, AreInNoQuadrantWithoutAPlace) {
  const std::vector<Point> places = {{50, 50}, {51, 51}, {52, 52}, {53, 53},
                                     {54, 54}, {0, 49},  {40, 40}};
  constexpr int kSize = 7, kCount = 4;
  std::vector<Cost> matrix;
  matrix.reserve(std::size_t{kSize} * kSize);
  for (const Point& a : places)
    for (const Point& b : places)
      matrix.push_back(static_cast<Cost>(std::fabs(a.x - b.x) + std::fabs(a.y - b.y)));
  const auto of = [&](std::span<const Point> placed, int stop) {
    const Candidates candidates({kSize, matrix.data()}, placed, kCount);
    std::vector<int> found;
    for (const Candidates::Leg& leg : candidates.of(stop)) found.push_back(leg.to);
    return found;
  };
  const std::span<const Point> all(places), but_last = all.first(kSize - 1);
  EXPECT_EQ(of(all, 0), (std::vector<int>{1, 2, 3, 6}));
  EXPECT_EQ(of(all, 6), (std::vector<int>{0, 1, 2, 5}));
  EXPECT_EQ(of(but_last, 0), (std::vector<int>{1, 2, 3, 5}));
  EXPECT_EQ(of(but_last, 6), (std::vector<int>{0, 1, 2, 3}));
}

TEST(TourLocalSearch, KicksKeepATourAndNeverMakeItDearer) {
  for (const int size : {8, 9, 10, 40}) {
    const Instance stops = random_instance(size, 3);
    const Costs costs = stops.costs();
    const Candidates candidates(costs, stops.places, 8);
    Poller poller(kNeverStops);
    kernels::RandomStream random(1, 0, 0);
    ArrayTour tour(costs, savings_order(costs, candidates));
    LocalSearch search(costs, candidates);
    for (int i = 0; i < 300; ++i) {
      const std::int64_t before = tour.cost();
      ASSERT_TRUE(search.kick(tour, 1, random, poller));
      ASSERT_LE(tour.cost(), before);
      ASSERT_EQ(tour.cost(), cost_of(costs, tour.order(), false));
      std::vector<int> sorted = tour.order();
      std::sort(sorted.begin(), sorted.end());
      for (int v = 0; v < size; ++v) ASSERT_EQ(sorted[v], v);
    }
  }
}

TEST(TourRecombiner, TakesOverWhatIsCheaper) {
  const Instance stops = random_instance(40, 3);
  const Costs costs = stops.costs();
  const Candidates candidates(costs, stops.places, 8);
  Poller poller(kNeverStops);
  kernels::RandomStream random(1, 0, 0);
  ArrayTour tour(costs, random_order(costs, candidates, random));
  const ArrayTour better(costs, savings_order(costs, candidates));
  Recombiner recombiner(costs, candidates);
  for (int i = 0; i < 20; ++i) {
    const std::int64_t before = tour.cost();
    const bool cheaper = recombiner.improve(tour, better, random, poller);
    EXPECT_EQ(cheaper, tour.cost() < before);
    EXPECT_EQ(tour.cost(), cost_of(costs, tour.order(), false));
  }
  EXPECT_LE(tour.cost(), better.cost());
}

// In corridors that branch a tour passes each twice, and no tour is shorter.
TEST(TourLocalSearch, PassesEachCorridorTwice) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    kernels::RandomStream random(seed, 0, 0);
    constexpr int kSize = 150;
    std::vector<Cost> matrix(std::size_t{kSize} * kSize, 0);
    std::int64_t all = 0;
    for (int v = 1; v < kSize; ++v) {
      const int from = std::max(0, v - 1 - random.below(6)), length = 1 + random.below(1000);
      all += length;
      for (int w = 0; w < v; ++w)
        matrix[v * kSize + w] = matrix[w * kSize + v] = matrix[from * kSize + w] + length;
    }
    OrderOptions options;
    options.generations = 0;
    EXPECT_EQ(find_order({kSize, matrix.data()}, {}, {}, options).cost, 2 * all) << "seed " << seed;
  }
}

// On the plane savings are some 12% above the shortest tour, ends joined at random far more.
TEST(TourOrder, BySavingsIsNotMuchLonger) {
  for (const std::uint32_t seed : {2U, 4U, 6U}) {
    const Instance stops = random_instance(120, seed, false);
    const Candidates candidates(stops.costs(), stops.places, 10, {});
    OrderOptions options;
    options.generations = 5;
    const OrderFound best = find_order(stops.costs(), {}, stops.places, options);
    const auto order = savings_order(stops.costs(), candidates);
    EXPECT_LT(static_cast<double>(cost_of(stops.costs(), order, false)),
              1.16 * static_cast<double>(best.cost));
  }
}

}  // namespace
}  // namespace lasius::tour
