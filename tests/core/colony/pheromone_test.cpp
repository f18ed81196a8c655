// An own update's hand on the trail, with numbers worked by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/base/special_values.h"
#include "lasius/base/error.h"
#include "lasius/params/own_rules.h"
#include "tests/core/base/refusal.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

using Places = std::vector<TrailPlace>;
using Values = std::vector<double>;

/// Acts on a trail of 40 x 3 cells with tau 1 everywhere, after one iteration.
void act(Trail trail, const std::function<void(Pheromone&)>& action, const char* name = "ras") {
  Params params = quick(name);
  params.trail = trail;
  params.neighbours = Neighbours::eight;
  params.initial_pheromone = 1;
  params.iterations = 1;
  int acted = 0;
  const OwnRules own{.update = [&](Pheromone& pheromone, const IterationTours&) {
    ++acted;
    action(pheromone);
  }};
  (void)Planner(Grid(40, 3)).plan({.start = {0, 1}, .goal = {30, 1}}, params, {.own_rules = own});
  EXPECT_EQ(acted, 1);
}

Values tau(const Pheromone& trail, const Places& places) {
  Values values(places.size());
  trail.get(places, values);
  return values;
}

TEST(Pheromone, PersistsEverywhereAndAddsToPlaces) {
  act(Trail::cells, [](Pheromone& trail) {
    EXPECT_EQ(trail.trail(), Trail::cells);
    EXPECT_EQ(trail.places(), 120);
    trail.persist(0.5);
    trail.add(Places{7, 45, 7}, 2);               // 0.5 + 2 + 2; 0.5 + 2
    trail.add(Places{119, 45}, Values{0.25, 1});  // 0.5 + 0.25; 2.5 + 1
    EXPECT_EQ(tau(trail, {7, 45, 119, 8}), (Values{4.5, 3.5, 0.75, 0.5}));
    trail.persist(0.25);
    EXPECT_EQ(tau(trail, {7, 45, 119, 8}), (Values{1.125, 0.875, 0.1875, 0.125}));
    EXPECT_EQ(trail.untouched(), 0.125);
    trail.set(Places{7, 8}, Values{3, 0.0625});
    EXPECT_EQ(tau(trail, {7, 8, 9}), (Values{3, 0.0625, 0.125}));
  });
}

TEST(Pheromone, ArcsHaveTheirOwn) {
  act(Trail::arcs, [](Pheromone& trail) {
    EXPECT_EQ(trail.places(), 120 * 8);
    trail.add(Places{8 * 41 + 4}, 2);  // out of (1, 1) to the right
    EXPECT_EQ(tau(trail, {8 * 41 + 3, 8 * 41 + 4, 8 * 41 + 5}), (Values{1, 3, 1}));
  });
}

TEST(Pheromone, IsReadWithinBoundsThatNothingStoredFeels) {
  act(Trail::cells, [](Pheromone& trail) {
    trail.add(Places{7}, 3);  // 4
    trail.persist(0.5);       // 2; elsewhere 0.5
    EXPECT_EQ(trail.least(), 0);
    EXPECT_EQ(trail.most(), kInfinity);
    trail.clamp(0.75, 1.5);
    EXPECT_EQ(tau(trail, {7, 8}), (Values{1.5, 0.75}));
    trail.persist(0.5);  // 1; elsewhere 0.25
    EXPECT_EQ(tau(trail, {7, 8}), (Values{1, 0.75}));
    trail.add(Places{8, 9}, Values{0.25, 4});  // on what is read
    EXPECT_EQ(tau(trail, {8, 9}), (Values{1, 1.5}));
    trail.clamp(0, kInfinity);
    EXPECT_EQ(tau(trail, {7, 8, 9, 10}), (Values{1, 1, 4.75, 0.25}));
  });
}

TEST(Pheromone, TilesHoldWhatIsStored) {
  act(Trail::cells, [](Pheromone& trail) {
    trail.persist(0.5);
    trail.add(Places{0, 35}, 2);  // in two tiles
    int found = 0;
    for (int i = 0; i < trail.tiles(); ++i) {
      const TrailTile tile = trail.tile(i);
      ASSERT_EQ(tile.stored.size(), 32U * 32U);
      EXPECT_EQ(tile.first.y, 0);
      for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 32 && tile.first.x + x < 40; ++x, ++found)
          EXPECT_EQ(tile.stored[32 * y + x] * trail.scale(),
                    tau(trail, {40 * y + tile.first.x + x})[0]);
      }
    }
    EXPECT_EQ(found, 120);
  });
}

TEST(Pheromone, StaysPositiveAndFinite) {
  act(Trail::cells, [](Pheromone& trail) {
    trail.set(Places{3}, Values{0});
    EXPECT_GT(tau(trail, {3})[0], 0);
    EXPECT_LT(tau(trail, {3})[0], 1e-29);
    for (int i = 0; i < 50; ++i) trail.persist(0);
    EXPECT_GT(tau(trail, {3})[0], 0);
    trail.add(Places{4}, Pheromone::kMost);
    EXPECT_GT(tau(trail, {4})[0], tau(trail, {3})[0]);
    EXPECT_LT(tau(trail, {4})[0], kInfinity);
  });
}

TEST(Pheromone, CellsTeachOnlyWhereTheHeuristicIsLearned) {
  act(
      Trail::cells,
      [](Pheromone& trail) {
        Values eta(2);
        trail.get_learned(Places{3, 4}, eta);
        EXPECT_EQ(eta, (Values{1, 1}));
        trail.set_learned(Places{3}, Values{2.5});
        trail.get_learned(Places{3, 4}, eta);
        EXPECT_EQ(eta, (Values{2.5, 1}));
        EXPECT_THROW(trail.get_learned(Places{120, 0}, eta), Error);
        EXPECT_THROW(trail.set_learned(Places{3}, Values{-1}), Error);
      },
      "cong2009");
  act(Trail::cells, [](Pheromone& trail) {
    Values eta(1);
    EXPECT_THROW(trail.get_learned(Places{3}, eta), Error);
    EXPECT_THROW(trail.set_learned(Places{3}, eta), Error);
  });
}

TEST(Pheromone, RefusesWhatIsNoPlaceOrNoPheromoneAndChangesNothing) {
  act(Trail::cells, [](Pheromone& trail) {
    const auto add = [&](const Places& places, const Values& values) {
      return refusal([&] { trail.add(places, values); });
    };
    const auto set = [&](const Places& places, const Values& values) {
      return refusal([&] { trail.set(places, values); });
    };
    for (const auto& change : {std::function(add), std::function(set)}) {
      expect_says(change({5, 120}, {9, 9}), "places[1] is 120");
      expect_says(change({5, 120}, {9, 9}), "0 to 119");
      expect_says(change({5, 6, -1}, {9, 9, 9}), "places[2] is -1");
      expect_says(change({5, 6}, {9}), "1 values for 2 places");
      expect_says(change({5, 6}, {9, std::nan("")}), "values[1] is nan");
      expect_says(change({5, 6}, {9, -0.5}), "values[1] is -0.5");
      expect_says(change({5, 6}, {9, kInfinity}), "values[1] is inf");
    }
    for (const double amount : {-1.0, std::nan(""), kInfinity, 1e201})
      expect_says(refusal([&] { trail.add(Places{5}, amount); }), "amount is ");
    expect_says(refusal([&] { trail.add(Places{500}, 1); }), "places[0] is 500");
    for (const double share : {-0.1, 1.1, std::nan("")})
      expect_says(refusal([&] { trail.persist(share); }), "persistence is ");
    for (const double least : {-0.1, kInfinity, std::nan("")})
      expect_says(refusal([&] { trail.clamp(least, kInfinity); }), "least is ");
    for (const double most : {0.0, 0.5, std::nan("")})
      expect_says(refusal([&] { trail.clamp(most == 0 ? 0 : 1, most); }), "most is ");
    Values two(2);
    expect_says(refusal([&] { trail.get(Places{1}, two); }), "2 values for 1 places");
    expect_says(refusal([&] { trail.get(Places{1, 120}, two); }), "places[1] is 120");
    expect_says(refusal([&] { (void)trail.tile(trail.tiles()); }), "tile ");
    EXPECT_EQ(tau(trail, {5, 6, 7}), (Values{1, 1, 1}));
  });
}

}  // namespace
}  // namespace lasius
