// The widest disc that passes, ends where none may be, curves of no length.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/poller.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

// Where cells are joined through which no disc passes.
TEST(DiscPlanner, TheWidestDiscPassesAndAWiderOneDoesNot) {
  Grid three(14, 15);
  for (const Cell c : {Cell{2, 7}, {4, 10}, {6, 13}}) three.set_blocked(c);
  EXPECT_EQ(Planner(three).widest_disc({2, 10}, {9, 1}), std::sqrt(5.0) / 2);
  std::mt19937 random(12);
  int between = 0;
  for (int round = 0; round < 1000; ++round) {
    Grid grid(14, 15);
    for (int blocks = random_in(3, 7, random); blocks > 0; --blocks)
      grid.set_blocked(random_cell(grid, random));
    const Request ends{random_cell(grid, random), random_cell(grid, random)};
    const auto widest = Planner(grid).widest_disc(ends.start, ends.goal);
    if (!widest || ends.start == ends.goal) continue;
    EXPECT_EQ(Planner(grid, Disc{*widest}).plan(ends).status, Status::solved) << *widest;
    const Result wider = Planner(grid, Disc{*widest + 1e-6}).plan(ends);
    EXPECT_TRUE(wider.path.empty() || wider.way_out) << *widest;
    between += wider.status == Status::unreachable;
  }
  EXPECT_GT(between, 10);
}

TEST(DiscPlanner, CurvesThatAreHardlyLongerThanNothingAreAnswered) {
  Grid grid(19, 22);
  for (const Cell c :
       {Cell{15, 0}, {7, 1},   {14, 1},  {13, 2},  {7, 3},  {8, 3},  {4, 4},   {12, 4},  {16, 4},
        {1, 5},      {10, 5},  {1, 6},   {10, 7},  {4, 8},  {2, 9},  {16, 10}, {4, 11},  {10, 11},
        {1, 13},     {10, 13}, {14, 13}, {1, 14},  {3, 14}, {7, 14}, {8, 14},  {11, 14}, {15, 14},
        {18, 14},    {4, 15},  {9, 15},  {0, 16},  {6, 16}, {1, 17}, {10, 17}, {9, 18},  {17, 18},
        {7, 19},     {14, 19}, {6, 20},  {12, 20}, {2, 21}, {14, 21}})
    grid.set_blocked(c);
  const Result result =
      Planner(grid, Disc{2.5}).plan({.start = {18, 12}, .goal = {12, 16}, .goal_tolerance = 10});
  ASSERT_TRUE(result.way_out);
  EXPECT_LT(result.length - std::hypot(result.way_out->x - 18.5, result.way_out->y - 12.5), 0.01);
}

TEST(DiscPlanner, AStartThatIsShutInIsRefusedInLinearTime) {
  constexpr int kSide = 1024;
  Grid grid = walled(kSide, kSide, {{510, 510, 5, 5}});
  grid.fill({511, 511, 3, 3}, false);
  const Planner planner(grid, Disc{2});
  EXPECT_GT(planner.footprint().disc, 0);
  const CountingTime time(1 << 30);
  const Result refused = planner.plan({.start = {512, 512}, .goal = {3, 3}, .stop = time.is_up()});
  EXPECT_EQ(refused.fault, Fault::start_blocked);
  // About 50 words are looked at for a cell.
  EXPECT_LT(time.polls(), 20 + 64 * kSide * kSide / Poller::kWords);
  EXPECT_GT(time.polls(), 16 * kSide * kSide / Poller::kWords);
  const CountingTime none(0);
  EXPECT_EQ(planner.plan({.start = {512, 512}, .goal = {3, 3}, .stop = none.is_up()}).status,
            Status::limit);
}

}  // namespace
}  // namespace lasius
