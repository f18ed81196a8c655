// The field of values on edges: marched in one go or several, stopped, and made a lower bound.
#include "core/cost/edge_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/cost/coarse_bound.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/cost_paths.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/weights.h"

namespace lasius::cost {
namespace {

// A march that goes on takes up values from before the queue's buckets, on ways that are longer
// than these: in order, or the values stay far too great.
TEST(EdgeField, GoesOnAsIfItHadNotStopped) {
  const Grid grid(700, 60);
  std::vector<double> weights(700 * 60);
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = 1 + 0.05 * static_cast<double>((i / 60 * 7 + i % 60 * 13) % 11) / 11;
  const Terrain terrain(grid, CostField(700, 60, weights));
  const StraightBound rest(terrain, {690.5, 30.5});
  const CellChords chords(4);
  Poller poller(kNeverStops);
  EdgeField once(terrain), twice(terrain);
  for (EdgeField* field : {&once, &twice}) field->begin(chords, {5, 30}, 0.01, nullptr);
  ASSERT_TRUE(twice.march(rest, 690, poller));
  const std::size_t before = twice.cells().size();
  ASSERT_TRUE(once.march(rest, 740, poller) && twice.march(rest, 740, poller));
  EXPECT_LT(before, twice.cells().size());
  ASSERT_EQ(once.cells().size(), twice.cells().size());
  double values[16], again[16];
  for (const std::uint32_t at : once.cells()) {
    once.values_of(terrain.cell(at), values);
    twice.values_of(terrain.cell(at), again);
    for (int i = 0; i < 16; ++i) {
      if (values[i] < kInfinity) {
        ASSERT_NEAR(again[i], values[i], 0.01);
      }
    }
  }
}

// A power of two: nothing is rounded otherwise.
TEST(EdgeField, ReachesCellsInTheSameOrderInAnotherUnit) {
  std::mt19937 random(41);
  const WeightedWorld world = random_weights(random, 30, 60);
  const CellChords chords(4);
  const auto marched = [&](double unit) {
    std::vector<double> weights;
    for (const double w : world.costs.weights()) weights.push_back(w * unit);
    const Terrain terrain(world.grid, {world.grid.width(), world.grid.height(), weights});
    const StraightBound rest(terrain, centre(world.goal));
    Poller poller(kNeverStops);
    EdgeField field(terrain);
    field.begin(chords, world.start, 0.01, nullptr);
    EXPECT_TRUE(field.march(rest, 1000 * unit, poller));
    return field.cells();
  };
  EXPECT_EQ(marched(0x1p-16), marched(1));
}

// What lies beyond the limit costs time, too: it is dealt out, and put by. Of a march that spreads
// next to nothing a stop is seen all the same.
TEST(EdgeField, StopsAmongWhatLiesBeyondTheLimit) {
  const Grid grid(200, 200);
  std::vector<double> weights(200 * 200);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = i % 2 == 0 ? 9e5 : 1;
  const Terrain terrain(grid, CostField(200, 200, weights));
  const StraightBound rest(terrain, {190.5, 100.5});
  const CellChords chords(4);
  Poller poller(kNeverStops);
  EdgeField field(terrain);
  field.begin(chords, {100, 100}, 0.01, nullptr);
  ASSERT_TRUE(field.march(rest, 9e6, poller));
  const std::size_t cells = field.cells().size();
  const CountingTime counted(1 << 30), up(0);
  const StopCondition counting = counted.is_up(), stop = up.is_up();
  Poller every(counting, 1), stopped(stop, 1);
  ASSERT_TRUE(field.march(rest, 9e6, every));
  EXPECT_EQ(field.cells().size(), cells);
  EXPECT_GT(counted.polls(), 1000);
  EXPECT_FALSE(field.march(rest, 9e6, stopped));
  EXPECT_EQ(up.polls(), 1);
}

// The values of every level, marched for itself over all cells, obey chords between random points.
TEST(EdgeField, RandomChordsCostEnough) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::int64_t chords_tried = 0;
  for (int i = 0; i < 40; ++i) {
    const auto [grid, costs, start, goal] = random_weights(random, 5, 12);
    const Terrain terrain(grid, costs);
    const auto weight = [&costs = costs](Cell c) { return costs.weight(c); };
    const double best =
        i % 4 == 0 ? oracle::cost_over_points(grid, weight, centre(start), centre(goal), 5) : 1e300;
    for (const int k : {2, 4, 8}) {
      const CellChords chords(k);
      EdgeField field(terrain);
      Poller poller(kNeverStops);
      field.begin(chords, start, 0, nullptr);
      ASSERT_TRUE(field.march(StraightBound(terrain, centre(goal)), 1e300, poller));
      ASSERT_TRUE(field.certify(poller));
      const double excess = field.excess();
      EXPECT_LE(field.measured_excess(poller), excess);
      EXPECT_LE(field.bound(goal), best);
      EXPECT_EQ(field.bound_of_leaving(), kInfinity);
      std::vector<double> values(chords.places());
      for (const std::uint32_t at : field.cells()) {
        const Cell cell = terrain.cell(at);
        field.values_of(cell, values.data());
        for (int c = 0; c < 40; ++c, ++chords_tried) {
          const auto point = [&](double t, Point& p) {
            const int low = std::min(static_cast<int>(t * chords.places()), chords.places() - 1);
            const int high = (low + 1) % chords.places();
            const double share = t * chords.places() - low;
            const Point a = chords.at(low), b = chords.at(high);
            p = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
            return values[low] + share * (values[high] - values[low]);
          };
          Point a, b;
          const double at_a = point(unit(random), a), at_b = point(unit(random), b);
          EXPECT_LE((at_b - at_a) / excess,
                    costs.weight(cell) * std::hypot(a.x - b.x, a.y - b.y) + 1e-11);
        }
      }
    }
  }
  EXPECT_GT(chords_tried, 100000);
}

}  // namespace
}  // namespace lasius::cost
