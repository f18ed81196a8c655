// Crossings of a chain of cells, at their cheapest.
#include "core/cost/crossings.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace lasius::cost {
namespace {

// Turned by half, the two ends of every edge change places: what holds at one end holds at the
// other.
TEST(Crossings, CostTheSameTurnedByHalf) {
  std::mt19937 random(1);
  const int n = 6;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Crossing> there, turned;
    std::vector<double> weights{random() % 2 == 0 ? 1.0 : 30.0};
    Cell cell{0, 0};
    for (int i = 0; i < n; ++i) {
      const Cell next = random() % 2 == 0 ? Cell{cell.x + 1, cell.y} : Cell{cell.x, cell.y + 1};
      there.push_back(crossing_between(cell, next));
      turned.push_back(crossing_between({n - cell.x, n - cell.y}, {n - next.x, n - next.y}));
      there.back().t = turned.back().t = 0.5;
      weights.push_back(random() % 2 == 0 ? 1.0 : 30.0);
      cell = next;
    }
    const Point to = {cell.x + 0.5, cell.y + 0.5};
    const double cost = CrossingsOptimizer().optimize({0.5, 0.5}, to, there, weights, 30);
    const double again = CrossingsOptimizer().optimize(
        {n + 0.5, n + 0.5}, {n + 1 - to.x, n + 1 - to.y}, turned, weights, 30);
    EXPECT_NEAR(cost, again, 1e-9 * cost) << trial;
  }
}

}  // namespace
}  // namespace lasius::cost
