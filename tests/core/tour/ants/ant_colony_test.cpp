#include "core/tour/ants/ant_colony.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/tour/order/subset_dp.h"
#include "lasius/error.h"
#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

constexpr std::string_view kFamilies[] = {"as", "eas", "ras", "mmas", "acs"};

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
        for (const Improvement improvement : {Improvement::none, Improvement::three_edges}) {
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
  EXPECT_GT(cases, 150);
}

// The same colony with alpha 0 sees no trail.
TEST(AntColony, ATrailShortensToursAtEqualWork) {
  const Instance stops = random_instance(40, 7, false);
  for (const std::string_view family : kFamilies) {
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
  std::stop_source source;
  source.request_stop();
  const OrderFound none = find_order_by_ants(stops.costs(), {}, true, AntParams("as"), 1,
                                             {.stop = {.token = source.get_token()}}, run);
  EXPECT_EQ(none.cause, StopCondition::Cause::token);
  EXPECT_TRUE(none.order.empty());
  AntParams wrong("as");
  wrong.greedy = 0.5;
  EXPECT_THROW(validate(wrong), Error);
  EXPECT_THROW(AntParams("mmaz"), Error);
  AntParams set("acs");
  set_parameter(set, "evaporation", "0.25");
  set_parameter(set, "local_search", "two-edges");
  EXPECT_EQ(get_parameter(set, "persistence"), "0.75");
  EXPECT_EQ(set.local_search, Improvement::two_edges);
  EXPECT_EQ(formulas(set).size(), 4U);
  EXPECT_TRUE(formulas(AntParams()).empty());
}

}  // namespace
}  // namespace lasius::tour
