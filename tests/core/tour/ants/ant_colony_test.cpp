#include "core/tour/ants/ant_colony.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "core/tour/ants/improver.h"
#include "core/tour/order/subset_dp.h"
#include "core/tour/order/window_search.h"
#include "lasius/base/error.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/order/given.h"
#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

constexpr std::string_view kFamilies[] = {"as", "eas", "ras", "mmas", "acs", "has-sop", "eacs"};

AntParams few(std::string_view family, int iterations,
              Improvement improvement = Improvement::none) {
  AntParams params(family);
  params.iterations = iterations;
  params.local_search = improvement;
  return params;
}

TEST(AntColony, VisitsEveryStopOnceAndKeepsEnds) {
  int cases = 0;
  for (const std::string_view family : kFamilies)
    for (const Ends& ends : kEnds)
      for (const int size : {1, 2, 5, 20})
        for (const Improvement improvement :
             {Improvement::none, Improvement::three_edges, Improvement::pieces}) {
          if (std::max(ends.start, ends.goal) >= size) continue;
          const Instance stops = random_instance(size, 3, true);
          AntParams params = few(family, 8, improvement);
          if (cases % 3 == 0) params.candidates = 4;
          Convergence one, two;
          const OrderFound found =
              find_order_by_ants(stops.costs(), ends, true, params, 1, {}, one);
          const OrderFound again =
              find_order_by_ants(stops.costs(), ends, true, params, 3, {}, two);
          std::vector<int> sorted = found.order, all(size);
          std::ranges::sort(sorted);
          std::iota(all.begin(), all.end(), 0);
          EXPECT_EQ(sorted, all);
          EXPECT_TRUE(ends.start < 0 || found.order.front() == ends.start);
          EXPECT_TRUE(ends.goal < 0 || found.order.back() == ends.goal);
          EXPECT_EQ(found.cost, cost_of(stops.costs(), found.order, ends.open));
          EXPECT_EQ(found.order, again.order);
          EXPECT_EQ(one.best, two.best);
          EXPECT_EQ(one.iterations, found.cost > 0 ? 8 : 1);  // 0 is the target
          EXPECT_EQ(one.arrived.back(), params.ants > 0 ? params.ants : size);
          ++cases;
        }
  EXPECT_GT(cases, 350);
}

// The same colony with alpha 0 sees no trail.
TEST(AntColony, ATrailShortensToursAtEqualWork) {
  const Instance stops = random_instance(40, 7, false);
  for (const std::string_view family : std::span(kFamilies).first(5)) {
    double with = 0, without = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      for (const double alpha : {1.0, 0.0}) {
        AntParams params = few(family, family == "acs" ? 600 : 150);  // 6000 tours
        params.alpha = alpha;
        params.beta = 2;
        Convergence run;
        const OrderFound found =
            find_order_by_ants(stops.costs(), {}, true, params, 1, {.seed = seed}, run);
        (alpha > 0 ? with : without) += static_cast<double>(found.cost);
      }
    EXPECT_LT(with, (family == "acs" ? 1 : 0.97) * without) << family;
  }
}

TEST(AntColony, WithLocalSearchFindsTheOptimumOfFewStops) {
  for (const std::string_view family : kFamilies)
    for (const Improvement improvement : {Improvement::two_edges, Improvement::three_edges})
      for (const Ends& ends : kEnds) {
        const Instance stops = random_instance(12, 5, true);
        Convergence run;
        const OrderFound found =
            find_order_by_ants(stops.costs(), ends, true, few(family, 40, improvement), 1, {}, run);
        EXPECT_EQ(found.cost,
                  cost_of(stops.costs(), subset_order(stops.costs(), ends, {}), ends.open))
            << family;
      }
}

TEST(AntColony, StepsWhereTheOrderAllows) {
  const Instance stops = random_instance(14, 5, true);
  std::vector<Before> relation;
  std::vector<int> loads(14, 0);
  for (int i = 1; i + 1 < 14; i += 2) {
    relation.emplace_back(i, i + 1);
    loads[i] = 1;
    loads[i + 1] = -1;
  }
  const PartialOrder given(14, relation, loads, 2);
  for (const std::string_view family : kFamilies)
    for (const Ends& ends : {Ends{}, Ends{false, 0}, Ends{true, 0}, Ends{true, 1, 0}}) {
      Convergence run;
      const OrderFound found =
          find_order_by_ants(stops.costs(), ends, true, few(family, 30), 1, {.given = &given}, run);
      ASSERT_EQ(found.order.size(), 14U) << family;
      std::vector<int> place(14);
      for (int i = 0; i < 14; ++i) place[found.order[i]] = i;
      for (const auto& [a, b] : relation) EXPECT_LT(place[a], place[b]);
      EXPECT_TRUE(given.carries(found.order));
    }
}

// Costs that differ with their direction, of -1 where the other stop comes before.
Instance directed(int size, std::uint32_t seed, const Given& given) {
  Instance made = random_instance(size, seed, true);
  kernels::RandomStream random(seed, 2, 0);
  for (Cost& cost : made.matrix) cost = random.below(100);
  for (const auto& [a, b] : given.relation) made.matrix[b * size + a] = -1;
  return made;
}

// The program over subsets is checked against all orders elsewhere.
TEST(AntColony, ExchangesOfPiecesFindTheBestOrderGivenInPart) {
  constexpr int kSize = 9;
  int found_best = 0, cases = 0;
  for (std::uint32_t seed = 1; seed <= 25; ++seed)
    for (const Ends& ends : {Ends{true, 0, kSize - 1}, Ends{true}, Ends{false, 2}, Ends{false}}) {
      const Given drawn = random_given(kSize, seed, ends);
      const PartialOrder given = drawn.order(kSize);
      const Instance stops =
          ends.open ? directed(kSize, seed, drawn) : random_instance(kSize, seed, true);
      const std::vector<int> best = subset_order(stops.costs(), ends, given);
      for (const std::string_view family : {"has-sop", "eacs"}) {
        Convergence one, three;
        const auto found_by = [&](int threads, Convergence& run) {
          return find_order_by_ants(stops.costs(), ends, !ends.open, few(family, 40), threads,
                                    {.given = &given}, run);
        };
        const OrderFound found = found_by(1, one);
        EXPECT_EQ(found.order, found_by(3, three).order);
        EXPECT_EQ(one.mean, three.mean);
        if (best.empty()) {
          EXPECT_TRUE(found.order.empty());
          continue;
        }
        ASSERT_EQ(found.order.size(), best.size());
        EXPECT_TRUE(kept(found.order, drawn, ends));
        EXPECT_GE(found.cost, cost_of(stops.costs(), best, ends.open));
        found_best += found.cost == cost_of(stops.costs(), best, ends.open);
        ++cases;
      }
    }
  EXPECT_GT(cases, 120);
  // Closed tours without a start keep the one that they began with.
  EXPECT_GT(found_best, 0.8 * cases);
}

TEST(AntColony, EnhancedAntsGoOnAsTheBestTourDoes) {
  const Instance stops = random_instance(60, 9, true);
  AntParams params("eacs");
  params.iterations = 30;
  params.drawn = 1e-9;  // q0 is 1: but for the first ants all go as the best one
  Convergence run;
  const OrderFound found = find_order_by_ants(stops.costs(), {true, 0}, true, params, 1, {}, run);
  EXPECT_EQ(run.mean.back(), static_cast<double>(found.cost));
  EXPECT_EQ(run.best.back(), static_cast<double>(found.cost));
  params.drawn = 10;
  const OrderFound drawn = find_order_by_ants(stops.costs(), {true, 0}, true, params, 1, {}, run);
  EXPECT_LT(drawn.cost, found.cost);
}

TEST(Improver, ExchangesPiecesOnlyWhereTheOrderDiffers) {
  const Given drawn = random_given(30, 3, {true, 0});
  const PartialOrder given(30, drawn.relation);
  Given relation;
  relation.relation = drawn.relation;
  const Instance stops = random_instance(30, 3, true);
  const Ends ends{true, 0};
  const Costs costs = stops.costs();
  Improver improver(costs, ends, given, Improvement::pieces, true, 1, kNeverStops);
  Poller poller(kNeverStops);
  const std::vector<int> first = first_order(costs, ends, given).order;
  EXPECT_EQ(improver.improved(first, first, 0, poller), first);  // differs nowhere
  const std::vector<int> better = improver.improved(first, {}, 0, poller);
  EXPECT_LT(cost_of(costs, better, true), cost_of(costs, first, true));
  EXPECT_TRUE(kept(better, relation, ends));
  EXPECT_EQ(improver.improved(better, {}, 0, poller), better);  // none is cheaper
}

TEST(AntColony, StopsAndRefuses) {
  const Instance stops = random_instance(30, 5, true);
  Convergence run;
  int told = 0;
  const OrderFound found = find_order_by_ants(
      stops.costs(), {}, true, AntParams("mmas"), 1,
      {.observer = [&](std::span<const int>, std::int64_t) { return ++told < 3; }}, run);
  EXPECT_EQ(told, 3);
  EXPECT_EQ(found.cause, StopCondition::Cause::none);
  EXPECT_LT(run.iterations, 1000);
  const OrderFound none =
      find_order_by_ants(stops.costs(), {}, true, AntParams("as"), 1, {.stop = fired()}, run);
  EXPECT_EQ(none.cause, StopCondition::Cause::token);
  EXPECT_TRUE(none.order.empty());
  AntParams wrong("as");
  wrong.greedy = 0.5;
  EXPECT_THROW(validate(wrong), Error);
  EXPECT_THROW(AntParams("mmaz"), Error);
  AntParams many("as");
  many.ants = 1'000'000;
  const Instance wide = random_instance(101, 5, true);
  EXPECT_THROW(find_order_by_ants(wide.costs(), {}, true, many, 1, {}, run), Error);
  AntParams set("acs");
  set_parameter(set, "evaporation", "0.25");
  set_parameter(set, "local_search", "two-edges");
  EXPECT_EQ(get_parameter(set, "persistence"), "0.75");
  EXPECT_EQ(set.local_search, Improvement::two_edges);
  EXPECT_EQ(formulas(set).size(), 4U);
  EXPECT_TRUE(formulas(AntParams()).empty());
  EXPECT_NE(formulas(AntParams("eacs"))[2].find("as the best tour so far"), std::string::npos);
  AntParams other("acs");
  other.drawn = 5;
  EXPECT_THROW(validate(other), Error);
}

}  // namespace
}  // namespace lasius::tour
