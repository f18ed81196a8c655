#include <gtest/gtest.h>

#include <utility>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/tour/cover.h"
#include "tests/core/base/counting_time.h"

namespace lasius {
namespace {

// The longer it has, the better: of the same swaths never longer, and from the first on in an order
// that keeps to corridors, where ends of swaths that are near through a wall are not joined.
TEST(Cover, IsNotLongerTheLaterItIsCut) {
  const Planner planner(generate(MapKind::maze, {.width = 36, .height = 36, .seed = 3}), Disc{0.5});
  CoverRequest request;
  request.width = 1;
  request.threads = 1;
  request.generations = 0;
  const auto cost_of = [](const CoverResult& cover) { return cover.tour.length / cover.covered; };
  const CoverResult whole = plan_cover(planner, request);
  ASSERT_EQ(whole.tour.status, Status::solved);
  ASSERT_GT(whole.swaths(), 60);
  int cut = 0;
  CoverResult before;
  for (int polls = 0; polls < 1 << 16; polls += 1 + polls) {
    SCOPED_TRACE(polls);
    const CountingTime time(polls);
    request.stop = time.is_up();
    CoverResult cover = plan_cover(planner, request);
    if (cover.tour.status == Status::solved) break;
    ++cut;
    ASSERT_FALSE(cover.tour.order.empty());
    EXPECT_GT(cover.covered, 0.9 * whole.covered);
    EXPECT_LT(cost_of(cover), 1.3 * cost_of(whole));
    if (cover.stops == before.stops) {
      // Orders are compared in grains of 1/1000 cell a leg.
      EXPECT_LE(cover.tour.length,
                before.tour.length + 1e-3 * static_cast<double>(cover.tour.order.size()));
    }
    before = std::move(cover);
  }
  EXPECT_GT(cut, 10);
}

// The time for plans is up, that of the tour is not.
TEST(Cover, TellsThatPlansWereCut) {
  CoverRequest request;
  request.width = 2;
  const CountingTime time(2);  // whose shares are taken
  request.stop = time.is_up();
  request.stop.deadline += std::chrono::hours(1);
  const Planner planner(Grid(12, 4), Disc{0.5});
  EXPECT_EQ(plan_cover(planner, request).tour.status, Status::limit);
}

// Between pillars one swath each is laid that others cut back: too many in want of time, which is
// no fault of the width's.
TEST(Cover, RefusesNoWidthForWantOfTime) {
  Grid grid(210, 210);
  for (int y = 1; y < 210; y += 2)
    for (int x = 1; x < 210; x += 2) grid.set_blocked({x, y}, true);
  const Planner planner(grid);
  CoverRequest request;
  request.width = 8;
  request.threads = 2;
  request.generations = 0;
  const CountingTime time(0);
  request.stop = time.is_up();
  const CoverResult cover = plan_cover(planner, request);
  EXPECT_EQ(cover.tour.status, Status::limit);
  EXPECT_TRUE(cover.stops.empty());
  EXPECT_TRUE(cover.tour.order.empty());
  // A width whose swaths are too many in every direction is known only in time.
  request.width = 1;
  EXPECT_EQ(plan_cover(planner, request).tour.status, Status::limit);
  request.stop = {};
  EXPECT_THROW(static_cast<void>(plan_cover(planner, request)), Error);
}

}  // namespace
}  // namespace lasius
