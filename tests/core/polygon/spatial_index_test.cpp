#include "core/polygon/spatial_index.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tests/worlds/random_world.h"

namespace lasius::polygon {
namespace {

TEST(SpatialIndex, ShowWhatSegmentsMeetAndWhatLiesAround) {
  Dice dice(3);
  for (const int side : {1, 40, 1 << 30}) {
    const auto place = [&] { return LatticePoint{dice.whole(0, side), dice.whole(0, side)}; };
    std::vector<std::pair<LatticePoint, LatticePoint>> segments;
    SpatialIndex cells({0, 0}, {side, side}, 60);
    for (int i = 0; i < 60; ++i) {
      segments.emplace_back(place(), i % 3 == 0 && i > 0 ? segments[0].first : place());
      cells.add(i, segments[i].first, segments[i].second);
    }
    int met = 0;
    for (int i = 0; i < 60; ++i) {
      const auto [a, b] = segments[i];
      std::set<int> near, around;
      cells.near(a, b, [&](int number) { return near.insert(number).second || true; });
      const double reach = 0.1 * side;
      cells.within(a, reach, [&](int number) { around.insert(number); });
      for (int k = 0; k < 60; ++k) {
        const auto [c, d] = segments[k];
        EXPECT_TRUE(near.contains(k) || !segments_meet(a, b, c, d)) << i << " " << k;
        const LatticePoint apart = c - a;
        const double x = static_cast<double>(apart.x), y = static_cast<double>(apart.y);
        EXPECT_TRUE(around.contains(k) || x * x + y * y > reach * reach) << i << " " << k;
        met += segments_meet(a, b, c, d) ? 1 : 0;
      }
    }
    EXPECT_GT(met, 100);
    EXPECT_FALSE(cells.near({0, 0}, {side, side}, [](int) { return false; }));
  }
}

}  // namespace
}  // namespace lasius::polygon
