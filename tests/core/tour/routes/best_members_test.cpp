#include "core/tour/routes/best_members.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/core/tour/order/instances.h"

namespace lasius::tour {
namespace {

TEST(Routes, ChooseTheCheapestStopsOfAnOrder) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed)
    for (const int from : {-1, 9}) {
      const Instance instance = random_instance(11, seed, true);
      const std::vector<std::vector<int>> layers = {{0, 1, 2}, {3}, {4, 5}, {6, 7, 8}};
      std::vector<const std::vector<int>*> told;
      for (const auto& layer : layers) told.push_back(&layer);
      const bool ring = from < 0;
      const int to = ring ? -1 : 10;
      const auto sum = [&](const std::vector<int>& stops) {
        std::int64_t cost = cost_of(instance.costs(), stops, !ring);
        if (!ring)
          cost += instance.costs()(from, stops.front()) + instance.costs()(stops.back(), to);
        return cost;
      };
      auto least = std::numeric_limits<std::int64_t>::max();
      for (const int a : layers[0])
        for (const int c : layers[2])
          for (const int d : layers[3]) least = std::min(least, sum({a, 3, c, d}));
      EXPECT_EQ(sum(best_members(instance.costs(), told, ring, from, to)), least);
    }
}

}  // namespace
}  // namespace lasius::tour
