// What is kept of a vehicle's way, at its extremes: wide maps, dear motions, cusps.
#include "core/drive/kept_way.h"

#include <gtest/gtest.h>

#include "lasius/vehicle/navigator.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

const std::vector<Point> kBox = rectangle(2, 5, 2);

TEST(KeptWay, NewsMayBeAsWideAsAMap) {
  const Vehicle vehicle = car(kBox, 5);
  const int wide = Grid::kMaxSide;
  Navigator navigator(Grid(wide, 16), vehicle, {{60, 8, 0}});
  const Pose start{10, 8, 0};
  ASSERT_EQ(navigator.step(start).status, Status::solved);
  navigator.observe(std::vector<Cell>{{0, 0}, {wide - 1, 15}}, true);
  EXPECT_FALSE(navigator.step(start).replanned);
  navigator.observe(std::vector<Cell>{{0, 1}, {40, 8}, {wide - 1, 14}}, true);
  EXPECT_TRUE(navigator.step(start).replanned);
  // A way from end to end.
  const std::vector<Segment> way{{.begin = start, .length = wide - 20.0}};
  const std::vector<Cell> beside{{0, 8}, {300, 4}, {20000, 12}, {wide - 1, 8}};
  EXPECT_FALSE(meets(vehicle, way, beside));
  for (const Cell on : {Cell{300, 7}, Cell{20000, 9}, Cell{wide - 6, 8}})
    EXPECT_TRUE(meets(vehicle, way, std::vector<Cell>{beside[0], beside[3], on}));
  EXPECT_FALSE(meets(vehicle, way, {}));
  EXPECT_FALSE(meets(vehicle, {}, beside));
}

// A turn in place, and one motion after the other: each is looked at as a whole.
TEST(KeptWay, MeetsWhatATurnSweeps) {
  const Vehicle vehicle = differential(kBox);
  const std::vector<Segment> turn{{.begin = {50, 50, 0}, .length = 0, .gear = 0, .angle = 3}};
  const auto met = [&](Cell c) { return meets(vehicle, turn, std::vector<Cell>{c}); };
  EXPECT_TRUE(met({50, 54}));   // the nose at a quarter of a turn
  EXPECT_TRUE(met({45, 50}));   // and near its end
  EXPECT_FALSE(met({50, 45}));  // on the other side
  EXPECT_FALSE(met({44, 44}));
}

// Straight on something is in the way: it turns away from what it meets.
TEST(KeptWay, LeadsOutByATurn) {
  const Grid grid = with_blocked(60, 60, {{33, 31}, {37, 30}});
  const auto out = ways_out(differential(kBox), grid, {30, 30, 0});
  ASSERT_FALSE(out.empty());
  EXPECT_EQ(out[0].gear, 0);
  EXPECT_GT(out[0].angle, -0.6);  // at -0.39 the side is past the corner (3, 1)
  EXPECT_LT(out[0].angle, -0.3);
}

TEST(KeptWay, LeadsBackWhereBackwardsIsDear) {
  const Grid grid(200, 60);
  Vehicle vehicle = car(kBox, 5);
  vehicle.reverse_cost = 1000;
  const std::vector<Segment> rest{{.begin = {150, 30, 0}, .length = 100, .gear = -1}};
  const Pose robot{150, 30.2, 0};
  int back = 0;
  const auto way = rejoined(vehicle, grid, robot, 0.2, rest, back);
  ASSERT_FALSE(way.empty());
  EXPECT_EQ(way.front().begin, robot);
  EXPECT_NEAR(way.back().end().x, rest.back().end().x, 1e-6);
  EXPECT_LT(cost(vehicle, way), cost(vehicle, rest) + 2);
}

// A word back beyond a cusp has one as well: the way without it has that price, too.
TEST(KeptWay, LeadsBackAcrossACusp) {
  const Grid grid(200, 60);
  Vehicle vehicle = car(kBox, 5);
  vehicle.cusp_cost = 50;
  std::vector<Segment> rest{{.begin = {50, 30, 0}, .length = 1.5}};
  rest.push_back({.begin = rest[0].end(), .length = 40, .gear = -1});
  int back = 0;
  const auto way = rejoined(vehicle, grid, {50, 30.1, 0}, 0.1, rest, back);
  ASSERT_FALSE(way.empty());
  EXPECT_LT(cost(vehicle, way), cost(vehicle, rest) + 5);
}

// A clothoid of a turn and more, from curvature -0.25 to 0.25 and on.
TEST(KeptWay, LocatesAPoseOnAClothoid) {
  const Segment s{.begin = {50, 50, 0}, .curvature = -0.25, .curvature_rate = 0.0125, .length = 60};
  KeptWay kept(car(kBox, 4));
  for (double at = 0.5; at < s.length; at += 0.5) {
    kept.keep({s});
    EXPECT_LT(kept.locate(s.pose(at)), 1e-3) << at;
  }
}

}  // namespace
}  // namespace lasius::vehicle
